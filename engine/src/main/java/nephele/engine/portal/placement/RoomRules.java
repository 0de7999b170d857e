package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Solid;
import nephele.engine.level.layout.FacePath;
import nephele.engine.level.layout.Told;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;

/**
 * The rule that what an author marked portalable has a place for the gun's portals: a face that says so itself, and a
 * solid that says so for all faces, of which at least one has a place. One warning for each surface.
 */
public final class RoomRules {
    /** Levels with more solids are not checked: grouping their faces takes too long. */
    private static final int MOST_SOLIDS = 10_000;

    public static final LevelRule LARGE_ENOUGH = new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
        if (level.portalGun() != null && statics.solids().size() <= MOST_SOLIDS) {
            new Search(level, statics).run(report);
        }
    });

    private RoomRules() {}

    /** Returns true if a face's own record permits portals. */
    private static boolean isMarked(Solid solid, BrushFace face) {
        if (solid instanceof Solid.Planes planes) {
            return planes.planes().stream().anyMatch(plane -> plane.portalable() == Boolean.TRUE)
                    && isMarked(planes, face.name());
        } else if (solid instanceof Solid.Box box) {
            for (BoxFace side : BoxFace.values()) {
                if (side.text().equals(face.name())) {
                    return isMarked(box.faces().get(side));
                }
            }
        } else if (solid instanceof Solid.Wedge wedge) {
            return isMarked(wedge.faces().get(face.name()));
        }
        return false;
    }

    private static boolean isMarked(Solid.Planes planes, String name) {
        for (int i = 0; i < planes.planes().size(); i++) {
            if (name.equals("planes[" + i + "]")) {
                return Boolean.TRUE.equals(planes.planes().get(i).portalable());
            }
        }
        return false;
    }

    private static boolean isMarked(Solid.Face said) {
        return said != null && Boolean.TRUE.equals(said.portalable());
    }

    private static final class Search {
        private final Level level;
        private final StaticShapes statics;
        private final PlacementSurfaces surfaces;
        private final RegionRoom room;
        private final Map<Integer, Boolean> fits = new LinkedHashMap<>();

        Search(Level level, StaticShapes statics) {
            this.level = level;
            this.statics = statics;
            surfaces = PlacementSurfaces.of(statics);
            room = new RegionRoom(Gun.of(level.portalGun()).aperture());
        }

        void run(Consumer<Problem> report) {
            Told told = new Told("solids", report);
            Map<Integer, List<String>> tight = new LinkedHashMap<>();
            Map<Integer, BrushFace> shown = new LinkedHashMap<>();
            int face = 0;
            for (int i = 0; i < statics.solids().size(); i++) {
                Brush brush = statics.solids().get(i);
                Solid said = level.solids().get(i);
                boolean isUseless = said.portalable();
                for (BrushFace each : brush.faces()) {
                    int region = surfaces.regionOfFace(face++);
                    isUseless = isUseless && !(each.portalable() && takes(region));
                    if (each.portalable() && isMarked(said, each) && !takes(region)) {
                        tight.computeIfAbsent(region, key -> new ArrayList<>()).add(FacePath.of(level, i, each.name()));
                        shown.putIfAbsent(region, each);
                    }
                }
                if (isUseless) {
                    told.accept(Problem.warning(FacePath.of(i) + ".portalable", message("none of its faces has"))
                            .about(Topic.TOO_SMALL_FOR_PORTAL));
                }
            }
            tight.forEach((region, paths) ->
                    told.accept(Problem.warning(paths.get(0) + ".portalable", message("the surface has"))
                            .about(new Subject(
                                    Topic.TOO_SMALL_FOR_PORTAL,
                                    paths.subList(1, paths.size()),
                                    shown.get(region).polygon()))));
        }

        private boolean takes(int region) {
            return region >= 0 && fits.computeIfAbsent(region, index -> room.fitsIn(surfaces.region(index)));
        }

        private String message(String start) {
            return start + " no place for the gun's portals, "
                    + level.portalGun().widthMetres() + " × "
                    + level.portalGun().heightMetres() + " m: make it larger, free it, or leave portalable out";
        }
    }
}
