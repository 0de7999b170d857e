package nephele.engine.level;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;

/** Portals come in pairs that name each other. */
final class PortalRules {
    static final LevelRule LINKS = (level, assets, report) -> {
        Map<String, PortalSpec> byId = new HashMap<>();
        level.portals().forEach(portal -> byId.putIfAbsent(portal.id(), portal));
        for (int i = 0; i < level.portals().size(); i++) {
            link("portals[" + i + "]", level.portals().get(i), byId, report);
        }
    };

    private PortalRules() {}

    private static void link(String path, PortalSpec portal, Map<String, PortalSpec> byId, Consumer<Problem> report) {
        PortalSpec partner = byId.get(portal.linkedTo());
        String objection = null;
        if (partner == null) {
            objection = "there is no portal '" + portal.linkedTo() + "'";
        } else if (portal.linkedTo().equals(portal.id())) {
            objection = "a portal cannot lead to itself";
        } else if (!partner.linkedTo().equals(portal.id())) {
            objection = "'" + partner.id() + "' is linked to '" + partner.linkedTo() + "': two portals name each other";
        }
        if (objection != null) {
            report.accept(Problem.error(path + ".linkedTo", objection));
        } else if (partner.widthMetres() != portal.widthMetres() || partner.heightMetres() != portal.heightMetres()) {
            report.accept(Problem.error(
                    path + ".widthMetres", "must be as wide and high as '" + partner.id() + "': portals do not scale"));
        }
        var across = portal.normal().toVector().cross(portal.up().toVector());
        double scale =
                portal.normal().toVector().length() * portal.up().toVector().length();
        if (scale > 0 && across.length() < 1e-6 * scale) {
            report.accept(Problem.error(path + ".up", "must not point along the normal"));
        }
    }
}
