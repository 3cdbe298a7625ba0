#include "interp/comments/tool_kind.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace mrsim {
namespace {

struct Names {
  ToolType type;
  ToolTrade trade;
  bool firm;
  double tip_angle;
  std::string_view phrases;  // apart by '|'
};

// '*' at the end of a word stands for any ending, '~' for a character outside of ASCII, '?' for one
// or two characters (FR?SER: FRÄSER, FRASER, FRAESER). The particular stands before the general.
namespace tool_names {
using enum ToolType;
using enum ToolTrade;
constexpr Names kNames[] = {
    {endmill, thread_mill, true, 0,
     "THREAD MILL*|THREADMILL*|THD MILL*|THRD MILL*|TMILL|GEWINDEFR*|FRAISE A FILETER|FRAISE "
     "FILET*|FRESA DE ROSCA*|"
     "FRESA PARA ROSCA*|FRESA ROSCA*|FRESA A FILETTARE|FRESA FILETT*|FRESA PER FILETTARE|FREZ DO "
     "GWINT*|FREZA NA Z?VIT*|REZKALO ZA NAVOJ*|FREZALO ZA NAVOJ*|NAVOJNO FREZALO|FREZA "
     "REZB*|REZBOFR*|GREBENKA"},
    {form, dovetail, true, 0,
     "DOVETAIL*|DOVE TAIL*|SCHWALBENSCHWANZ*|QUEUE D ARONDE|COLA DE MILANO|CODA DI "
     "RONDINE|JASK*|LASTOV*|FREZ "
     "TRAPEZOW*|RYBINOV*"},
    {form, rounding, true, 0,
     "RADIUS MILL|RADIUS CUTTER|RADIUS TOOL|CORNER ROUND*|ROUNDOVER|ROUND "
     "OVER|RADIUSFR*|VIERTELKREIS*|"
     "RADIUSNO FREZALO|FREZALO ZA RADI*|FRESA QUARTO*|FREZ PROMIEN*|FREZA RADIUS*|"
     "QUARTER ROUND|VIERTELRUND*|VIERTELRADIUS*|FRAISE QUART DE ROND|FRESA CUARTO*|FRESA A "
     "RAGGIARE"},
    {form, shaped, true, 0,
     "KOTNO FREZALO|PROFILNO FREZALO|FREZA UHL*|FREZA ~HL*|FREZ TR?JK*|FRESA MADRE|STEP MILL|"
     "STEP CUTTER|STEPPED MILL|FORM DRILL|FORM REAMER|FORM MILL|FORM TOOL|OFFTIPRAD*|FORM "
     "CUTTER|FORMFR*|PROFILFR*|TAPER REAMER|"
     "TAPERED REAMER|TAPER PIN*|STEP DRILL|STUFENBOHRER|FORET ETAGE|"
     "BROCA ESCALONADA|BACK CHAMFER*|BACK COUNTERSINK|BACK SPOT*|BACK COUNTERBORE|BACK BORE|"
     "BACKBORE|DOUBLE ANGLE|SINGLE ANGLE|ANGLE CUTTER|ANGLE MILL|ANGULAR CUTTER|WINKELFR*|"
     "PRISMENFR*|KONKAV*|KONVEX*|FRAISE CONIQUE DOUBLE|FRAISE ANGUL*|FRAISE D ANGLE|FRAISE "
     "CONCAVE|FRAISE CONVEXE|FRESA ANGUL*|FRESA ANGOL*|FRESA CONCAV*|FRESA CONVE*|FREZ K?TOW*|"
     "CONCAVE CUTTER|CONVEX CUTTER|CONCAVE MILL|CONVEX MILL|"
     "BEADING BIT|OGEE*|ROMAN OGEE*|COVE BIT|BOWL BIT|BOWL TRAY*|RABBET BIT|"
     "RABBETING BIT|RAISED PANEL*|UNDERCUT END*|UNDERCUT MILL|UNDERCUTTING*|"
     "FORMSTAHL|FORMDREH*|FORMMEISSEL|OUTIL DE FORME|UTENSILE DI FORMA|HERRAMIENTA DE FORMA|"
     "HALF ROUND*|CONE MILL|CONE CUTTER|CONE BIT|GEAR MILL|GEAR CUTTER|INVOLUTE*|"
     "TREPAN*|CORE CUTTER|HOLE SAW|HOLESAW|ANNULAR CUTTER|LENS MILL|LENS CUTTER|OVAL FORM*|FRESA "
     "REDONDA|"
     "DIAMOND DRAG|DRAG BIT|DRAG KNIFE|DRAG ENGRAV*|TANGENTIAL KNIFE"},
    {endmill, no_cutter, true, 0,
     "PROBE|MESSTASTER|TOUCH PROBE|EDGE FINDER|KANTENTASTER|WIRE BRUSH|BRUSH|DEBURRING BRUSH|"
     "STEADY REST|TAILSTOCK|TAIL STOCK|REVOLVING CENT*|ROTATING CENT*|TURRET STOP|FEED STOCK|"
     "STOCK FEED|PULL BAR|PUSH BAR|BAR PUSH*|"
     "NAREBRI*|RE?KANJE|OMEJILO|NASLON|PRISLON|PODAJALEC|STOP "
     "PIN|PUSHER|GRIPPER|BURNISH*|KNURL*|RAENDEL*|R~NDEL*|MOLETAGE|MOLETTE|MOLETEADO|"
     "ZIGRINATURA|LIVE CENTER|LIVE CENTRE|BAR STOP|BAR STOPPER|BARSTOP|STOCK STOP|MATERIAL "
     "STOP|WORK "
     "STOP|STOPPER|BAR PULLER|BARPULLER|BAR PULL|PULLER|BAR "
     "GRIPPER|STANGENANSCHLAG|"
     "WERKST?CKANSCHLAG|BAR FEED|BARFEED|BAR "
     "ADVANCE|STANGENVORSCHUB|MATERIALANSCHLAG|ANSCHLAG|STANGENGREIFER|GREIFER|TIRE BARRE|TIREUR "
     "DE BARRE|BUTEE|BUT?E|TOPE|"
     "TOPE DE BARRA|TIRABARRA*|TIRABARRE|FERMO BARRA|BARPULER|UPOR"},
    {boring, lathe, true, 0,
     "VRTALNI DROG*|IZSTRU?EV*|IZVRTAL*|BORING BAR|BORE BAR|BORINGBAR|BOHRSTANGE|TURNING "
     "BORING|BORING "
     "TURNING|INNENDREH*|AUSDREH*|BARRE D "
     "ALESAGE|BARRA DE MANDRINAR|"
     "WYTACZAK|WYTACZAD?O|RASTOCHN*"},
    {endmill, hole, true, 0,
     "IZSTRU?EV* GLAVA|IZVRTALNA GLAVA|BORING HEAD|AUSSPINDEL*|AUSDREHKOPF|FINE BORE*|FINE "
     "BORING*|FINEBORE*"},
    {grooving, lathe, true, 0,
     "GROOVING TOOL|GROOVING INSERT|GROOVE TOOL|TURNING GROOVING|GROOVE TURNING|PARTING "
     "TOOL|PARTING BLADE|"
     "PART OFF TOOL|CUTOFF TOOL|CUT OFF TOOL|STECHSTAHL|ABSTECHSTAHL|EINSTECHSTAHL|STECHPLATTE|"
     "STECHER|STECHM*|STECHDREH*|EINSTECHER|ABSTECHER|AXIALSTECH*|"
     "AXIALEINST*|STIRNSTECH*|STIRNEINST*|PLANSTECH*|PLANEINST*|"
     "RANURAR|OUTIL A GORGE|OUTIL A TRONCONNER|N?? DO ROWK*|N?? DO PRZECIN*|"
     "PRZECINAK|ZAPICHOV*|UPICHOV*|BESZUR*|BESZ~R*|LESZUR*|LESZ~R*|BEDAME|"
     "STEEKBEITEL|AFSTEEKBEITEL|AFSTEEK*|STICKST?L|AVSTICK*|ODREZNI NO*|ZAREZNI NO*|"
     "ODCINA*|WCINAK|NO? DO PODCI*|NO? DO PODTOCZ*|N?? DO PODCI*|N?? DO PODTOCZ*|ODREZIV*|"
     "ODREZNI|ODREZNIK|ZAREZNI|ODREZOVAL*|ODREZOVANJ*|ODREZILN*|ZAREZOVAL*|ZAREZOVANJ*|UTORNI "
     "NO*|VREZNI NO*|STEHAR*|STEH "
     "NO*|~TEHAR*|"
     "ODSJECANJ*|ODSECANJ*|USJECANJ*|USECANJ*|ABSTECHDREH*|EINSTECHDREH*|NUTENDREH*|NUTENSTAHL|"
     "ABSTECHSCHWERT|STECHSCHWERT|ABSTECHHALTER|EINSTECHHALTER|STECHHALTER|ABSTECHKLINGE|"
     "STECHKLINGE|LAME A TRONCONNER|OUTIL A SAIGNER|OTREZNO*|KANAVOCH*|CUTIT DE RETEZAT|"
     "CUTIT CANELAT|CUTIT DE CANELAT|KESME KALEM*|KATKAISU*|PISTOTER*|SPORSTICK*|SP?RSTICK*|"
     "STIKST?L|DAO CAT RANH|DAO CAT DUT"},
    {threading, lathe, true, 0,
     "THREADING TOOL|THREADING INSERT|TURNING THREADING|THREAD "
     "TURNING|GEWINDEDREH*|GEWINDESTAHL|GEWINDEPLATTE|N?? DO GWINT*|MENETKES|"
     "MENETK~S|ZAVITOVY N*|NAVOJNI NO*|CUTIT DE FILETAT|DIS KALEM*|DI~ KALEM*|VIDA KALEM*|"
     "DIS CEKME*|KIERRETER*|REZBOVO*|DAO TIEN REN"},
    {turning, lathe, true, 0,
     "TURNING TOOL|TURNING INSERT|GENERAL TURNING|TURNING GENERAL|TURN TOOL|SCHLICHTSTAHL|"
     "SCHRUPPSTAHL|OUTIL A CHARIOTER|OUTIL A DRESSER"},
    {lollipop, mill, true, 0, "LOLLIPOP*"},
    {barrel, mill, false, 0, "BARREL"},
    {tslot, disc, true, 0,
     "T SLOT|T SLOTTER|TSLOT|TEE SLOT|TEE SLOTTER|T NUTEN*|TNUTEN*|KEYSEAT|KEYSEATER|KEY SEAT|KEY "
     "CUTTER|KEYCUTTER|WOODRUFF*|"
     "SCHEIBENFR*|SLITTING SAW|SLOTTING SAW|SLITTING CUTTER|SIDE CUTTER|SIDE AND FACE*|SIDE MILL|"
     "SLOT CUTTER|SLOTTING CUTTER|DISC CUTTER|DISK CUTTER|DISC MILL|DISK MILL|SAWBLADE|TIPPEDDISC|"
     "SLOT SAW|SAW BLADE|JEWELERS SAW|CIRCULAR SAW|S?GEBLATT|KREISS?GE*|METALLS?GE*|FRAISE T|"
     "FRAISE EN T|FRAISE A RAINURER EN T|FRAISE A T|FRESA A T|FRESA PARA RANURAS EN T|FRAISE "
     "SCIE|FRAISE DISQUE|FRAISE 3 TAILLES|FRAISE TROIS TAILLES|FRESA T|FRESA EN "
     "T|FRESA A T|FRESA DE DISCO|"
     "FRESA A DISCO|FREZ T|FREZ TARCZOWY|FREZ TEOW*|FREZ DO ROWKOW TEOW*|FREZ DO ROWKOW T|"
     "T DRAZK*|T DR~ZK*|FREZA NA T DRAZK*|FREZA NA T DR~ZK*|FRESA PER CAVE A T|FRESA RANURA T|"
     "FRESA RANURAS T|FRESA RANURAS EN T|T NUT FR?SER|FR?SER F?R T NUT*|T UTOR*|FRESA DISCO|FRESA "
     "LAMA|FRESA SIERRA|FREZ PI?KOW*|FREZALO KOLUT*|FREZA KOTOU*|FREZA T|KOLUTNO FREZALO|T "
     "FREZALO|T REZKALO"},
    {tslot, disc, false, 0, "SAW|ZAGA|~AGA"},
    {endmill, hole, true, 0,
     "FLAT BOTTOM* DRILL|FLAT DRILL|HINGE DRILL|HINGE BIT|HINGE BORING BIT|BRAD POINT DRILL|"
     "BRAD POINT BIT|BRAD POINT"},
    {endmill, hole, false, 0, "SPOT FACE*|SPOTFACE*"},
    {drill, twist_drill, false, 0, "TAP DRILL*|TAPPING DRILL*|CORE DRILL*|KERNLOCH*"},
    {chamfer, vee, true, 0, "DRILL MILL|DRILLMILL|MILL DRILL"},
    {drill, spot_drill, true, 90,
     "SPOT DRILL*|SPOTDRILL*|NC BOHRER|SPOT DRL|SPT DRL|SPT DRILL|SPOTDRL|SPOTTING "
     "DRILL|SPOTTER|NC "
     "ANBOHRER|NCA|ANBOHRER|NC SPOT*|NC DRILL|"
     "FORET A POINTER|BROCA DE PUNTEAR"},
    {drill, spot_drill, false, 90, "SPOT|SPOTTING|PUNTEADO"},
    {drill, center_drill, true, 60,
     "ZABU?IVA?|PUNTA MATKAB*|NAVRT?V?K|CENTER DRILL*|CENTRE DRILL*|CENTERDRILL*|CENTREDRILL*|CTR "
     "DRILL|CTR DRL|"
     "CENTER DRL|CENTRE DRL|CNTR DRILL|CNTR DRL|CENT DRILL|CENT DRL|CDRL|C DRL|C "
     "DRILL|CDRILL|CDR|ZENTRIERBOHRER|"
     "ZENTRIERER|FORET A CENTRER|BROCA DE CENTR*|PUNTA DA CENTR*|PUNTA A CENTRARE|NAWIERTAK|"
     "CENTRIRNI SVEDER|SREDI?NI SVEDER|CENTRINO|CENTERBOOR|CENTROVOCH*|CENTROVK*|ZENTROVK*|"
     "SVERLO CENTR*"},
    {endmill, tap, true, 0,
     "UREZNI?|UREZNICA|G?NGTAPP|KIERRETAPPI|MENETF?R?|TAROD|GEWINDEBOHRER|MASCHINENGEWINDEBOHRER|"
     "GEW BOHRER|GEWINDEFORMER|GEWINDEFURCHER|TARAUD|MACHO|MACHUELO|MASCHIO|GWINTOWNIK|"
     "NAVOJNI SVEDER|NAVOJNIK|SVEDER ZA NAVOJ*|Z?VITN?K|KILAVUZ|TAPRH|TAPLH|FORM TAP|ROLL "
     "TAP|THREAD FORMER|THREADCUTTER|METCHIK*"},
    {endmill, tap, false, 0, "TAP|TAPPING"},
    {endmill, hole, true, 0,
     "CELNO GREZILO|~ELNO GREZILO|PLOSKO "
     "GREZILO|RAZVRTA?|RUIMER|RAYBA|BROTSCH|D?RZS?R|ALEZOR|V?STRU?N?K|REAMER|REAMERS|REIBAHLE*|"
     "MASCHINENREIB*|AL?SOIR|ESCARIADOR|ALESATORE|ALARGADOR|ROZWIERTAK|"
     "POVRTALO|"
     "FLACHSENKER|ZAPFENSENKER|FRAISE A LAMER|FORET A LAMER|AVELLANADOR PLANO|LAMATORE|"
     "POG??BIACZ WALCOW*|POG??BIACZ CZO?OW*|POGLEBIACZ WALCOW*|POGLEBIACZ CZOLOW*|"
     "Z?HLUBN?K V?LCOV*|RAZVERTK*"},
    {endmill, hole, false, 0, "REAM|REAMING|KALVIN|COUNTER BORE*|COUNTERBORE*|CBORE|C BORE"},
    {chamfer, countersink, true, 90,
     "UPU?TA?|UGREZ*|HAVSA|ESCAREADOR|KEGELSENKER|Z?HLUBN?K|FRAISE A "
     "FRAISURER|AVELLANADOR|SVASATORE|STO?CASTO GREZILO|ZENKOVK*"},
    {chamfer, countersink, false, 90,
     "COUNTERSINK*|COUNTER SINK*|CSINK|C SINK|CSK|SENKER|GREZILO|POG??BIACZ|POGLEBIACZ"},
    {chamfer, vee, true, 0,
     "FREZALO ZA GRAVIR*|FREZALO V|GRAVIRN* NO?|GRAVIRN* FREZALO|GRAVIRN* REZILO|V BIT*|VBIT*|V "
     "CUTTER|V TOOL|V MILL|VMILL|V "
     "ENDMILL|V END MILL|POINTED MILL|POINTED END*|"
     "VCARVE BIT|V GROOVE*|ENGRAVING TOOL|ENGRAVING CUTTER|"
     "ENGRAVING BIT|ENGRAVE TOOL|ENGRAVER|ENGRAVE "
     "MILL|GRAVIERSTICHEL|GRAVIERFR*|GRAVURSTICHEL|GRAVURFR*|FRAISE A GRAVER|"
     "FRESA DE GRABAR|BULINO|DEBURR MILL|DEBURR TOOL|DEBURR CUTTER|DEBURR BIT|DEBURR ENDMILL|"
     "DEBURR END MILL|DEBURRING MILL|DEBURRING TOOL|DEBURRING CUTTER"},
    {chamfer, vee, false, 0, "ENGRAV*|GRAVIER*"},
    {chamfer, chamfer_mill, true, 90,
     "FREZALO ZA POSNE*|FREZA NA SRA*|FREZA NA SR~*|POSNEMAL* FREZALO|POSNEMAL* REZKALO|CHAMFER "
     "MILL|CHAMFER TOOL|CHAMFER CUTTER|CHAMFER "
     "ENDMILL|CHAMFER END MILL|CHAMFER EM|"
     "CHAMFER BIT|CHAMFER DRILL|CHAMFERMILL|CHAMFERING TOOL|CHAMFERING CUTTER|CHAMFERING MILL|CHAM "
     "MILL|"
     "FASENFR*|FASFR*|GRATFR*|POSNEMAL*|ENTGRATER|ENTGRATFR*|FRAISE A CHANFREIN*|FRAISE "
     "CHANFREIN*|FRESA "
     "DE CHAFLAN*|"
     "FRESA CHAFLAN*|FRESA BISEL*|FRESA DE BISEL*|FRESA CHANFR*|FRESA DE CHANFR*|FRESA PER SMUSS*|"
     "FRESA A SMUSS*|FRESA SMUSS*|"
     "FAZOWNIK|FREZ DO FAZ*|FREZ FAZ*|SRA?EC*|SMUSSATORE|SMUSSATRICE|CHAMF MILL|CHAMF TOOL|CHAMF "
     "CUTTER|CHAMF END*|CHAMF BIT|CHMF MILL|"
     "CHFR MILL|CHMFR MILL"},
    {chamfer, chamfer_mill, false, 90,
     "CHAMFER|CHAMFERING|CHAM|CHANFREIN|CHAMF|CHMF|CHMFR|CHFR|FASE"},
    {taper, cone_ball, true, 0,
     "TAPERED BALL NOSE|TAPER BALL NOSE|TAPERED BALLNOSE|TAPERED BALL END*|TAPERED BALL|"
     "TAPER BALL|TBN|TAPERSPHERICAL"},
    {taper, cone_mill, true, 0,
     "KONUSNO FREZALO|CONICAL MILL|CONICAL END*|TAPERTIPPED|TAPERED MILL|TAPER MILL|TAPERED "
     "ENDMILL|TAPERED END "
     "MILL|TAPER "
     "ENDMILL|TAPER END MILL|"
     "TAPERED EM|TAPER EM|KONISCHER FR*|KEGELFR*|KONUSFR*|FRAISE CONIQUE|FRESA CONICA|FREZ "
     "STO?KOWY|"
     "KONI?NO FREZALO"},
    {ballmill, mill, true, 0,
     "KUGLAST*|LOPTAST*|PALLOJYRSIN|BALLNOSE*|BALL NOSE*|BALLMILL|BALL MILL|BALLENDMILL|BALL "
     "END*|BALL EM|BEM|BNEM|KUGELFR*|"
     "CORE BOX*|COREBOX*|ROUND NOSE BIT|ROUND NOSE END*|ROUND NOSE ROUTER*|ROUNDNOSE BIT|"
     "BALL CUTTER|BALL BIT|SPHERE MILL|SPHERE CUTTER|VOLLRADIUSFR*|KROGL*|KROGEL*|FRAISE "
     "BOULE|FRESA DE BOLA|FRESA "
     "BOLA|FRESA BOLEADA|FRESA TONDA|FRESA A PALLA|FRESA ESF|FREZ KUL*|BOLFREES|BOLKOP*|BOLNEUS*|"
     "KOGELFREES|FRAISE HEMI|BOUT HEMI|KUGELKOPF*|VOLLRADIUS FR*|BALLEND*|KULFR*|PALLOP*|G?MBMAR?|"
     "K?RE FREZE|K?RESEL FREZE"},
    {ballmill, mill, false, 0,
     "BALL|SPHERICAL|HEMISPHERICAL|KUGEL|BOULE|ESF?RICA|SF?RICA|SEMISFERICA|H?MISPH?RIQUE|SPH?"
     "RIQUE|KULISTY|KULOV?|GULOV?|SFERIC|SFERICH*|HEMI|"
     "PUNTA TONDA|PUNTA SFERICA"},
    {bullmill, mill, true, 0,
     "BULLNOSE*|BULL NOSE*|TORUSFR*|ECKRADIUSFR*|RADIUS END MILL|RADIUS ENDMILL|HIGH FEED MILL|"
     "BULL CUTTER|BULL MILL|BULLMILL|HIGH FEED CUTTER|HIGH FEED END*|HIGH FEED "
     "FACE*|HOCHVORSCHUBFR*|FEED "
     "MILL|FEEDMILL"},
    {bullmill, mill, false, 0, "BULL|HFM|HIGHFEED*|TORUS|TORUSNO|TORICA|TORIQUE|TOROID*"},
    {endmill, face_mill, true, 0,
     "FREZALNA GLAVA|CELNA GLAVA|~ELNA GLAVA|CEONO GLODALO|~EONO GLODALO|CEONA GLAVA|REZKALNA "
     "GLAVA|GLAVA ZA "
     "GLODANJE|TARAMA KAFA*|"
     "FACE MILL|FACEMILL|FACING MILL|FACINGTOOL|FACING TOOL|STIRNFR*|WALZENSTIRN*|SHELL "
     "MILL|SHELLMILL|FLY "
     "CUTTER|FLYCUTTER|PLANFR*|"
     "MESSERKOPF|PLANMESSERKOPF|ECKFR*|VLAKFREES|FRAISE A SURFACER|FRESA DE PLANEAR|PLATO DE "
     "PLANEAR|FRESA A "
     "SPIANARE|"
     "FRESA PER SPIANARE|G?OWICA|FREZ CZO?OWY|SURFACING BIT|SPOILBOARD*|FREZA TORC*|"
     "TORCEVAYA FREZ*|TORCEVAJA FREZ*"},
    {endmill, mill, true, 0,
     "FREZER|FREZA DEGET|FREZA VALCOVA|FRESA TOPO|FRESA DE "
     "TOPO|GLODALO|REZKALO|REZKAR|PINNFR?S*|ENDEFR*|"
     "JYRSIN|TAPPIJYRSIN|UJJMAR?|SZ?RMAR?|END MILL|ENDMILL|END MILLS|ENDMILLS|SLOT "
     "DRILL|SLOTDRILL|E MILL|EMILL|FLAT END*|FLAT "
     "MILL|FLATMILL|SQUARE "
     "MILL|SLOT "
     "MILL|SLOTMILL|"
     "RUFFER|HOG MILL|HOGMILL|ROUTER BIT|STRAIGHT BIT|COMPRESSION BIT|UPCUT BIT|DOWNCUT BIT|"
     "SPIRAL BIT|END CUTTER|O FLUTE|OFLUTE|CORN BIT|CORN CUTTER|FISH TAIL|FISHTAIL|FORSTNER*|"
     "MORTISE BIT|PARMAK*|FREZALO|STEBLAST*|SCHAFTFR*|SCHRUPPFR*|SCHLICHTFR*|LANGLOCHFR*|IGELFR*|"
     "BOHRNUTENFR*|NUTENFR*|FINGERFR*|WENDEPLATTENFR*|WENDESCHNEIDPLATTENFR*|"
     "EINSCHNEIDER|CORNCOB|CORN COB|HOGGER|FR?SER|FRESA|FRAISE|FREZ|FREES|"
     "VINGERFREES|FREZA|FREZE|FR?ZA"},
    {drill, twist_drill, true, 0,
     "BURGIJA|SVRDLO|KERNBOHRER|DRILL BIT|TWIST DRILL|SCREW MACHINE DRILL|SCREW MACH DRILL|SCREW "
     "MACH DRL|JOBBER DRILL|GUN "
     "DRILL|INSERT DRILL|SPADE DRILL|U "
     "DRILL|BOHRER|"
     "SPIRALBOHRER|VOLLBOHRER|WENDEPLATTENBOHRER|TIEFLOCHBOHRER|HARTMETALLBOHRER|SVEDER|"
     "BROCA|FORET|BURGHIU|WIERT?O|BOOR|SPIRAALBOOR|VRT?K|MATKAP|SVERLO|PUNTA "
     "ELICOIDALE"},
    {drill, twist_drill, false, 0,
     "DRILL|PREDRILL|BORR|PORA|DRL|DR|JOBBER|PUNTA|FURO|TALADRO|SVERLENIE|F~R~|CSIGAFURO"},
    {endmill, mill, false, 0,
     "UPCUT|DOWNCUT|UP CUT|DOWN CUT|COMPRESSION|ROUGHER|RGHR|FLAT|PLAT|MILL|EM|E M"},
    {turning, lathe, false, 0, "TURNING|DIAMOND|TRIGON"},
    {grooving, lathe, false, 0,
     "GROOVING|PARTING|CUTOFF|GROOVE|GROOVER|GRV|PARTER|PART OFF|PARTOFF|P OFF|CUT OFF|CUTTING "
     "OFF|EINSTECHEN|ABSTECHEN|STECHEN|EINSTICH|ABSTICH|INNENSTECH*|INNENEINSTECH*|INNENEINSTICH|"
     "TRONCONNAGE|GORGE|SAIGN?E|SAIGNER|GOLE|SANGRAR|SANGRAMENTO|ODCIECIE|PRZECINANIE|ZLJEB*|"
     "RANURADO|RANURADOR|"
     "RANURA|TRONZADO|TRONZADOR|TRONZAR|TRONCATORE|"
     "TRONCATURA|SCANALATURA|GOLA|PLUNGE "
     "CUTTER|BLADE|CANAL|ROWEK|ROWKI|ROWKOW|ROWKOWANIE|DR~ZKA|DRA~KA|DRAZKA|UTOR|KANAL|"
     "KANAVKA|KANAVKI|OTREZ|OTREZKA|ODREZ|ZAREZ|ZAREZA|UTORI|UTORA|UTORE"},
    {threading, lathe, false, 0,
     "THREADING|THREADER|THREAD|GEWINDE|INNENGEWINDE|AUSSENGEWINDE|ROSCADO|ROSCAR|ROSCA|FILETAGE|"
     "FILETER|"
     "FILETTATURA|FILETTARE|GWINT|GWINTOWANIE|ZAVIT|Z~VIT|NAVOJ|NAVOJA|MENET|REZBA"},
    // A tool of a lathe, whose use another word tells: "CUCHILLA TRONZADO".
    {turning, lathe, true, 0,
     "LATHE TOOL|DREHMEI*|DREHSTAHL|STRU~*|STRUZ*|CUCHILLA|NO~|NOZ|NUZ|N~~|REZEC|REZETS|PROHODNO*|"
     "PROXODNO*|PROKHODNO*"},
};
}  // namespace tool_names

bool fits(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern == "*") return true;
  if (pattern.front() != '?')
    return !text.empty() && text.front() == pattern.front() &&
           fits(pattern.substr(1), text.substr(1));
  return (!text.empty() && fits(pattern.substr(1), text.substr(1))) ||
         (text.size() > 1 && fits(pattern.substr(1), text.substr(2)));
}

// Whether the token is a sign between the words of a phrase: "T-SLOT", "C'SINK", "D'ARONDE".
bool joins_words(const CommentToken& token) {
  return token.glued && (token.is("-") || token.is("'") || token.is("/"));
}

// The place behind the phrase that begins at `at`, or 0 if it does not stand there.
std::size_t match_phrase(std::string_view words, const std::vector<CommentToken>& tokens,
                         std::size_t at) {
  for (bool first = true; !words.empty(); first = false) {
    const std::size_t blank = words.find(' ');
    if (!first && at < tokens.size() && joins_words(tokens[at])) ++at;
    if (at >= tokens.size() || tokens[at].kind == CommentToken::Kind::sign ||
        !fits(words.substr(0, blank), tokens[at].text))
      return 0;
    ++at;
    words = blank == words.npos ? std::string_view() : words.substr(blank + 1);
  }
  return at;
}

struct Phrase {
  std::string_view words;
  const Names* names;
};

// The phrases by their first letter, in the order of the table.
const std::vector<Phrase>& phrases_with(char letter) {
  static const auto kIndex = [] {
    std::array<std::vector<Phrase>, 256> index;
    for (const Names& names : tool_names::kNames)
      for (std::string_view rest = names.phrases; !rest.empty();) {
        const std::size_t bar = rest.find('|');
        const std::string_view words = rest.substr(0, bar);
        index[static_cast<unsigned char>(words.front())].push_back({words, &names});
        rest = bar == rest.npos ? std::string_view() : rest.substr(bar + 1);
      }
    return index;
  }();
  return kIndex[static_cast<unsigned char>(letter)];
}

struct Match {
  ToolKind kind;
  const Names* names;
};

bool overlap(const ToolKind& a, const ToolKind& b) { return a.first < b.end && b.first < a.end; }

}  // namespace

std::vector<ToolKind> find_tool_kinds(const std::vector<CommentToken>& tokens) {
  std::vector<Match> matches;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != CommentToken::Kind::word) continue;
    for (const Phrase& phrase : phrases_with(tokens[i].text.front())) {
      const std::size_t end = match_phrase(phrase.words, tokens, i);
      const Names& n = *phrase.names;
      if (end > 0) matches.push_back({{n.type, n.trade, n.firm, n.tip_angle, i, end}, &n});
    }
  }
  // The words of a firm phrase are not those of a soft one too: "SPOT DRILL" is no "DRILL".
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.names < b.names; });
  std::vector<ToolKind> kinds;
  for (const Match& match : matches)
    if (std::none_of(kinds.begin(), kinds.end(),
                     [&](const ToolKind& k) { return overlap(k, match.kind); }))
      kinds.push_back(match.kind);
  const bool pointed = std::any_of(kinds.begin(), kinds.end(),
                                   [](const ToolKind& k) { return k.type == ToolType::chamfer; });
  if (pointed)  // "CHAMFER 90 DEG, FLAT TIP 2MM"
    std::erase_if(kinds, [&](const ToolKind& k) {
      return k.end == k.first + 1 && tokens[k.first].is("FLAT");
    });
  const auto firm =
      std::find_if(kinds.begin(), kinds.end(), [](const ToolKind& k) { return k.firm; });
  if (firm == kinds.end() || firm == kinds.begin()) return kinds;
  // "CHAMFER WITH A 6MM ENDMILL": the tool is the end mill. "BALL ... ENDMILL" is a ball mill.
  const ToolKind certain = *firm;
  std::stable_partition(kinds.begin(), kinds.end(),
                        [&](const ToolKind& k) { return same_trade(k, certain); });
  kinds.front().firm = true;
  return kinds;
}

bool same_trade(const ToolKind& a, const ToolKind& b) {
  using enum ToolTrade;
  const auto family = [](const ToolKind& kind) {
    switch (kind.trade) {
      case face_mill:
      case cone_mill:
      case cone_ball:
        return mill;
      case center_drill:
        return twist_drill;
      case spot_drill:
      case countersink:
      case vee:
        return chamfer_mill;
      default:
        return kind.trade;
    }
  };
  return family(a) == family(b);
}

}  // namespace mrsim
