package nephele.editor.draw;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import nephele.engine.level.Billboards;
import nephele.engine.level.Body;
import nephele.engine.level.Cloud;
import nephele.engine.level.Emitter;
import nephele.engine.level.Environment;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.math.IdentityDiff;

/**
 * The level without the entities that its author has hidden. Lights shine on, and a model stays while another one that
 * is visible is placed relative to it.
 */
public final class VisibleLevel {
    private Level before;
    private Level visible;

    public Level of(Level level) {
        if (level != before) {
            visible = level.editor().hidden().isEmpty() ? level : without(level);
            before = level;
        }
        return visible;
    }

    private Level without(Level level) {
        Set<String> hidden = new HashSet<>(level.editor().hidden());
        Level shown = level.with(
                level.materials(),
                shown(level.solids(), "solids/", Solid::id, hidden),
                shown(level.bodies(), "bodies/", Body::id, hidden),
                models(level.models(), hidden));
        shown = shown.withPortals(shown(level.portals(), "portals/", PortalSpec::id, hidden));
        shown = shown.withExits(shown(level.exits(), "exits/", Exit::id, hidden));
        shown = shown.withEmitters(shown(level.emitters(), "emitters/", Emitter::id, hidden));
        shown = shown.withTerrains(shown(level.terrains(), "terrains/", Terrain::id, hidden));
        shown = shown.withBillboards(shown(level.billboards(), "billboards/", Billboards::id, hidden));
        Environment environment = level.environment();
        List<Cloud> clouds = shown(environment.clouds(), "environment.clouds/", Cloud::id, hidden);
        if (clouds.size() < environment.clouds().size()) {
            shown = shown.with(environment.withClouds(clouds), shown.lights());
        }
        return reused(shown);
    }

    private static <T> List<T> shown(List<T> all, String section, Function<T, String> id, Set<String> hidden) {
        List<T> shown = all.stream()
                .filter(record -> !hidden.contains(section + id.apply(record)))
                .toList();
        return IdentityDiff.list(all, shown);
    }

    private static List<ModelPlacement> models(List<ModelPlacement> all, Set<String> hidden) {
        Set<String> needed = new HashSet<>();
        int known = -1;
        while (needed.size() > known) {
            known = needed.size();
            for (ModelPlacement model : all) {
                boolean isShown = !hidden.contains("models/" + model.id()) || needed.contains(model.id());
                if (isShown && model.parent() != null) {
                    needed.add(model.parent());
                }
            }
        }
        List<ModelPlacement> shown = all.stream()
                .filter(model -> !hidden.contains("models/" + model.id()) || needed.contains(model.id()))
                .toList();
        return IdentityDiff.list(all, shown);
    }

    /** Keeps the lists of the last visible level, so that what follows from them is kept, too. */
    private Level reused(Level shown) {
        if (visible == null) {
            return shown;
        }
        return shown.with(
                shown.materials(),
                IdentityDiff.list(visible.solids(), shown.solids()),
                IdentityDiff.list(visible.bodies(), shown.bodies()),
                IdentityDiff.list(visible.models(), shown.models()));
    }
}
