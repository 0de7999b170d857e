package nephele.engine.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Subject;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.layout.FacePath;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.level.layout.FirstProblems;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/** The rule that no two faces of different materials lie in one plane, with one normal, where they are visible. */
final class FaceRules {
    /** Distance of planes whose depths a picture cannot tell apart. */
    private static final double SAME_PLANE_METRES = 1e-4;

    private static final double SAME_NORMAL = 1 - 1e-9;

    /** Least width of a place that is reported; narrower strips are under the edges of trims. */
    private static final double LEAST_WIDTH_METRES = 0.05;

    /** Distance in front of the faces where other solids hide them. */
    private static final double BEFORE_METRES = 1e-3;

    /** Greatest number of comparisons of faces: a second of work. */
    private static final int MOST_PAIRS = 5_000_000;

    /** Greatest number of pieces of a face; one in so many is taken for visible. */
    private static final int MOST_PIECES = 500;

    static final LevelRule APART = new LevelRule(
            LevelRule.Stage.LAYOUT, (level, assets, statics, report) -> new FaceRules(level, statics, report).run());

    private record Place(int solid, BrushFace face) {}

    private final Level level;
    private final BrushIndex solids;
    private final FirstProblems reported;
    private final List<Place> places = new ArrayList<>();
    private int pairs;

    private FaceRules(Level level, StaticShapes statics, Consumer<Problem> report) {
        this.level = level;
        solids = new BrushIndex(statics);
        reported = new FirstProblems("solids", report);
        for (int i = 0; i < statics.solids().size(); i++) {
            for (BrushFace face : statics.solids().get(i).faces()) {
                places.add(new Place(i, face));
            }
        }
    }

    private void run() {
        List<Aabb> boxes =
                places.stream().map(place -> Aabb.of(place.face().polygon())).toList();
        SpatialIndex index = SpatialIndex.of(boxes);
        ItemList near = new ItemList();
        for (int i = 0; i < places.size() && !reported.isFull() && pairs < MOST_PAIRS; i++) {
            near.clear();
            index.overlapping(boxes.get(i).grown(SAME_PLANE_METRES), near);
            near.sort();
            pairs += near.size();
            for (int j = 0; j < near.size() && near.get(j) < i; j++) {
                compare(places.get(i), places.get(near.get(j)));
            }
        }
    }

    private void compare(Place a, Place b) {
        boolean mayFight = a.solid() != b.solid()
                && !Objects.equals(a.face().material(), b.face().material())
                && isCoplanar(a.face(), b.face());
        if (mayFight) {
            List<Vec3> common = FacePieces.common(
                    a.face().polygon(), b.face().polygon(), a.face().plane().normal());
            if (FacePieces.widthMetres(common) >= LEAST_WIDTH_METRES && isVisible(common, a.face())) {
                report(a, b, common);
            }
        }
    }

    private boolean isVisible(List<Vec3> polygon, BrushFace face) {
        List<Vec3> before = polygon.stream()
                .map(corner -> corner.addScaled(BEFORE_METRES, face.plane().normal()))
                .toList();
        List<List<Vec3>> visible = List.of(before);
        ItemList near = solids.near(Aabb.of(before));
        for (int i = 0; i < near.size() && !visible.isEmpty() && visible.size() < MOST_PIECES; i++) {
            visible = FacePieces.outside(
                    visible, solids.brushes().get(near.get(i)).shape());
        }
        return visible.stream().anyMatch(piece -> FacePieces.widthMetres(piece) >= LEAST_WIDTH_METRES);
    }

    private void report(Place a, Place b, List<Vec3> common) {
        String other = FacePath.of(level, b.solid(), b.face().name());
        String message = "lies in one plane with face " + b.face().name() + " of "
                + FacePath.named(level, b.solid())
                + ", and the materials differ: they flicker: move one of them, or give both the same material";
        reported.accept(Problem.warning(FacePath.of(level, a.solid(), a.face().name()), message)
                .about(new Subject(Topic.FIGHTING_FACES, List.of(other), common)));
    }

    private static boolean isCoplanar(BrushFace a, BrushFace b) {
        return a.plane().normal().dot(b.plane().normal()) > SAME_NORMAL
                && b.polygon().stream()
                        .allMatch(corner -> Math.abs(a.plane().signedDistance(corner)) <= SAME_PLANE_METRES);
    }
}
