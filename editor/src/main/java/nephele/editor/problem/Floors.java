package nephele.editor.problem;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import nephele.editor.document.EntityBounds;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** The level's floors, best first: those below a ceiling, the largest, the lowest; and where a player can stand. */
final class Floors {
    private static final double LEVEL_COSINE = 0.99;
    private static final double HIGHEST_CEILING_METRES = 1000;

    /** Distance of the places that are tried on a floor, at most this many along each side. */
    private static final double STEP_METRES = 0.5;

    private static final int MOST_STEPS = 40;

    private static final int MOST_FLOORS = 50;

    private record Floor(BrushFace face, boolean isCovered, double squareMetres, double height) {}

    private final List<Floor> best;
    private final FreePlace free;

    Floors(Level level, StaticShapes statics) {
        free = new FreePlace(level, statics, null);
        BrushIndex solids = new BrushIndex(statics);
        List<Floor> floors = new ArrayList<>();
        for (Brush brush : statics.solids()) {
            for (BrushFace face : brush.faces()) {
                if (face.plane().ny() >= LEVEL_COSINE) {
                    floors.add(floor(face, solids));
                }
            }
        }
        floors.sort(Comparator.comparing((Floor floor) -> !floor.isCovered())
                .thenComparing(floor -> -floor.squareMetres())
                .thenComparing(Floor::height));
        best = floors.subList(0, Math.min(MOST_FLOORS, floors.size()));
    }

    private static Floor floor(BrushFace face, BrushIndex solids) {
        Vec3 middle = Aabb.of(face.polygon()).centre();
        Vec3 from = middle.plus(new Vec3(0, STEP_METRES, 0));
        boolean isCovered = solids.isBlocked(from, from.plus(new Vec3(0, HIGHEST_CEILING_METRES, 0)), 0);
        return new Floor(face, isCovered, FacePieces.areaSquareMetres(face.polygon()), middle.y());
    }

    /** Returns where a player has room nearest to the middle of the best floor; {@code null} for nowhere. */
    Vec3 middle() {
        for (Floor floor : best) {
            Vec3 middle = Aabb.of(floor.face().polygon()).centre();
            List<Vec3> places = places(floor.face());
            if (!places.isEmpty()) {
                return places.stream()
                        .min(Comparator.comparingDouble(
                                place -> place.minus(middle).length()))
                        .get();
            }
        }
        return null;
    }

    /** Returns where a player has room on the best floor, farthest from a place; {@code null} for nowhere. */
    Vec3 farFrom(Vec3 place) {
        for (Floor floor : best) {
            List<Vec3> places = places(floor.face());
            if (!places.isEmpty()) {
                return places.stream()
                        .max(Comparator.comparingDouble(
                                each -> each.minus(place).length()))
                        .get();
            }
        }
        return null;
    }

    private List<Vec3> places(BrushFace face) {
        Aabb box = Aabb.of(face.polygon());
        List<Vec3> places = new ArrayList<>();
        double stepX = Math.max(STEP_METRES, (box.maxX() - box.minX()) / MOST_STEPS);
        double stepZ = Math.max(STEP_METRES, (box.maxZ() - box.minZ()) / MOST_STEPS);
        Vec3 middle = box.centre();
        int reachX = (int) ((box.maxX() - middle.x()) / stepX);
        int reachZ = (int) ((box.maxZ() - middle.z()) / stepZ);
        for (int i = -reachX; i <= reachX; i++) {
            for (int j = -reachZ; j <= reachZ; j++) {
                Vec3 at = new Vec3(middle.x() + i * stepX, box.maxY(), middle.z() + j * stepZ);
                if (isOn(face, at) && free.isFree(EntityBounds.standing(at))) {
                    places.add(at);
                }
            }
        }
        return places;
    }

    private static boolean isOn(BrushFace face, Vec3 at) {
        for (int i = 0; i < face.polygon().size(); i++) {
            Vec3 from = face.polygon().get(i);
            Vec3 side = face.polygon().get((i + 1) % face.polygon().size()).minus(from);
            Vec3 outwards = Directions.unit(side.cross(face.plane().normal()));
            if (outwards != null && Plane.through(outwards, from).signedDistance(at) > 0) {
                return false;
            }
        }
        return true;
    }
}
