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
import nephele.engine.level.layout.FirstProblems;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;

/**
 * The rule that what an author marked portalable has a place for the gun's portals: a face that says so itself, and a
 * solid that says so for all faces, of which at least one has a place. One warning for each surface.
 */
public final class RoomRules {
    /** Levels with more solids are not checked: grouping their faces takes too long. */
    private static final int MOST_SOLIDS = 10_000;

    /** Greatest number of obstacles of a search; a region with more is taken for large. */
    private static final int MOST_LIMITS = 150;

    /** Number of headings that are tried over half a turn; a place that fits at others only is too tight to aim at. */
    private static final int HEADINGS = 12;

    /** |N.y| from which a portal's heading follows the shooter's view. */
    private static final double TILTED = 0.8660254037844386;

    public static final LevelRule LARGE_ENOUGH = new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
        if (level.portalGun() != null && statics.solids().size() <= MOST_SOLIDS) {
            new RoomRules(level, statics).report(report);
        }
    });

    private final Level level;
    private final StaticShapes statics;
    private final PlacementSurfaces surfaces;
    private final Aperture aperture;
    private final CentreSearch centres = new CentreSearch();
    private final Map<Integer, Boolean> fits = new LinkedHashMap<>();

    private RoomRules(Level level, StaticShapes statics) {
        this.level = level;
        this.statics = statics;
        surfaces = PlacementSurfaces.of(statics);
        aperture = Gun.of(level.portalGun()).aperture();
    }

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

    private static boolean isMarked(Solid.Face authored) {
        return authored != null && Boolean.TRUE.equals(authored.portalable());
    }

    private void report(Consumer<Problem> report) {
        FirstProblems reported = new FirstProblems("solids", report);
        Map<Integer, List<String>> tight = new LinkedHashMap<>();
        Map<Integer, BrushFace> firstFaces = new LinkedHashMap<>();
        int face = 0;
        for (int i = 0; i < statics.solids().size(); i++) {
            Brush brush = statics.solids().get(i);
            Solid authored = level.solids().get(i);
            boolean isUseless = authored.portalable();
            for (BrushFace each : brush.faces()) {
                int region = surfaces.regionOfFace(face++);
                isUseless = isUseless && !(each.portalable() && takes(region));
                if (each.portalable() && isMarked(authored, each) && !takes(region)) {
                    tight.computeIfAbsent(region, key -> new ArrayList<>()).add(FacePath.of(level, i, each.name()));
                    firstFaces.putIfAbsent(region, each);
                }
            }
            if (isUseless) {
                reported.accept(Problem.warning(FacePath.of(i) + ".portalable", message("none of its faces has"))
                        .about(Topic.TOO_SMALL_FOR_PORTAL));
            }
        }
        tight.forEach((region, paths) ->
                reported.accept(Problem.warning(paths.get(0) + ".portalable", message("the surface has"))
                        .about(new Subject(
                                Topic.TOO_SMALL_FOR_PORTAL,
                                paths.subList(1, paths.size()),
                                firstFaces.get(region).polygon()))));
    }

    private boolean takes(int region) {
        return region >= 0 && fits.computeIfAbsent(region, index -> fitsIn(surfaces.region(index)));
    }

    /** Returns true if the aperture fits somewhere, or if the region has too many limits for a search. */
    private boolean fitsIn(Region region) {
        if (region.outline().size() + region.bars().size() > MOST_LIMITS) {
            return true;
        }
        Vec3 up = PortalUpright.on(region.frame().normal(), Basis.WORLD);
        double startX = region.frame().xOf(up);
        double startY = region.frame().yOf(up);
        int headings = Math.abs(region.frame().normal().y()) > TILTED ? HEADINGS : 1;
        for (int i = 0; i < headings; i++) {
            double turn = Math.PI * i / HEADINGS;
            double cos = StrictMath.cos(turn);
            double sin = StrictMath.sin(turn);
            if (fitsIn(region, cos * startX - sin * startY, sin * startX + cos * startY)) {
                return true;
            }
        }
        return false;
    }

    private boolean fitsIn(Region region, double upX, double upY) {
        ConvexPolygon reflected = ConvexPolygon.reflected(aperture, upX, upY);
        if (!isAsLarge(region.faces().bounds(), reflected)) {
            return false;
        }
        centres.begin(reflected);
        for (int i = 0; i < region.outline().size(); i++) {
            centres.addOutline(region.outline().shape(i));
        }
        for (int i = 0; i < region.bars().size(); i++) {
            centres.add(region.bars().shape(i));
        }
        Aabb box = region.faces().bounds();
        Vec3 middle = box.centre();
        double reach = (box.maxX() - box.minX()) + (box.maxY() - box.minY());
        return centres.find(region, middle.x(), middle.y(), reach);
    }

    /** Compares the bounds only, which excludes most small surfaces without a search. */
    private static boolean isAsLarge(Aabb box, ConvexPolygon reflected) {
        double width = 0;
        double height = 0;
        for (int i = 0; i < reflected.corners(); i++) {
            for (int j = 0; j < i; j++) {
                width = Math.max(width, Math.abs(reflected.x(i) - reflected.x(j)));
                height = Math.max(height, Math.abs(reflected.y(i) - reflected.y(j)));
            }
        }
        double slack = 2 * (Tolerance.OVERLAP + Tolerance.CRACK);
        return width <= box.maxX() - box.minX() + slack && height <= box.maxY() - box.minY() + slack;
    }

    private String message(String start) {
        return start + " no place for the gun's portals, "
                + level.portalGun().widthMetres() + " × "
                + level.portalGun().heightMetres() + " m: make it larger, free it, or leave portalable out";
    }
}
