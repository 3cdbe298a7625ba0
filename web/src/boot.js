import { $ } from "./dom.js";
import { load } from "./data.js";

load().then(() => import("./main.js")).catch((error) => {
  $("no-gl").hidden = false;
  $("no-gl").textContent = `This page cannot be shown: ${error.message}`;
  console.error(error);
});
