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
    private Level last;

    public Level of(Level level) {
        if (level != before) {
            last = level.editor().hidden().isEmpty() ? level : without(level);
            before = level;
        }
        return last;
    }

    private Level without(Level level) {
        Set<String> hidden = new HashSet<>(level.editor().hidden());
        Level rest = level.with(
                level.materials(),
                visible(level.solids(), "solids/", Solid::id, hidden),
                visible(level.bodies(), "bodies/", Body::id, hidden),
                models(level.models(), hidden));
        rest = rest.withPortals(visible(level.portals(), "portals/", PortalSpec::id, hidden));
        rest = rest.withExits(visible(level.exits(), "exits/", Exit::id, hidden));
        rest = rest.withEmitters(visible(level.emitters(), "emitters/", Emitter::id, hidden));
        rest = rest.withTerrains(visible(level.terrains(), "terrains/", Terrain::id, hidden));
        rest = rest.withBillboards(visible(level.billboards(), "billboards/", Billboards::id, hidden));
        Environment environment = level.environment();
        List<Cloud> clouds = visible(environment.clouds(), "environment.clouds/", Cloud::id, hidden);
        if (clouds.size() < environment.clouds().size()) {
            rest = rest.with(environment.withClouds(clouds), rest.lights());
        }
        return reused(rest);
    }

    private static <T> List<T> visible(List<T> all, String section, Function<T, String> id, Set<String> hidden) {
        List<T> rest = all.stream()
                .filter(record -> !hidden.contains(section + id.apply(record)))
                .toList();
        return IdentityDiff.list(all, rest);
    }

    private static List<ModelPlacement> models(List<ModelPlacement> all, Set<String> hidden) {
        Set<String> needed = new HashSet<>();
        int known = -1;
        while (needed.size() > known) {
            known = needed.size();
            for (ModelPlacement model : all) {
                boolean isVisible = !hidden.contains("models/" + model.id()) || needed.contains(model.id());
                if (isVisible && model.parent() != null) {
                    needed.add(model.parent());
                }
            }
        }
        List<ModelPlacement> rest = all.stream()
                .filter(model -> !hidden.contains("models/" + model.id()) || needed.contains(model.id()))
                .toList();
        return IdentityDiff.list(all, rest);
    }

    /** Keeps the lists of the last visible level, so that what follows from them is kept, too. */
    private Level reused(Level rest) {
        if (last == null) {
            return rest;
        }
        return rest.with(
                rest.materials(),
                IdentityDiff.list(last.solids(), rest.solids()),
                IdentityDiff.list(last.bodies(), rest.bodies()),
                IdentityDiff.list(last.models(), rest.models()));
    }
}
