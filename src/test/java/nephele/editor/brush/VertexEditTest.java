package nephele.editor.brush;

import static nephele.editor.brush.SolidShape.assertAccepted;
import static nephele.editor.brush.SolidShape.bounds;
import static nephele.editor.brush.SolidShape.box;
import static nephele.editor.brush.SolidShape.volume;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class VertexEditTest {
    private static final Solid BOX = FaceLooks.withPortalable(
            FaceLooks.withMaterial(box("box", Vec3.ZERO, new Vec3(2, 2, 2)), 2, "tile"), 0, true);
    private static final Vec3 CORNER = new Vec3(2, 2, 2);

    private static Solid moved(Solid solid, List<Vec3> vertices, Vec3 by) {
        return VertexEdit.moved(solid, vertices, by).result().orElseThrow();
    }

    /** Returns the vertices of an edited solid that are nearest to where an edit moved some. */
    private static List<Vec3> after(List<Vec3> vertices, Vec3 by, Solid edited) {
        return vertices.stream()
                .map(vertex -> VertexEdit.vertices(edited).stream()
                        .min(Comparator.comparingDouble(
                                v -> v.minus(vertex.plus(by)).length()))
                        .orElseThrow())
                .distinct()
                .toList();
    }

    private static BrushText refusal(Solid solid, List<Vec3> vertices, Vec3 by) {
        return VertexEdit.moved(solid, vertices, by).refusal().orElseThrow();
    }

    private static List<Vec3> top() {
        return VertexEdit.vertices(BOX).stream().filter(v -> v.y() == 2).toList();
    }

    @Test
    void solidsHaveTheVerticesAndEdgesOfEulersFormula() {
        RandomSolids solids = new RandomSolids(40);
        for (int i = 0; i < 40; i++) {
            Solid solid = solids.next();
            int faces = Brush.of(solid).faces().size();
            assertEquals(
                    VertexEdit.edges(solid).size() + 2,
                    VertexEdit.vertices(solid).size() + faces,
                    solid.toString());
        }
    }

    @Test
    void aBoxWithItsTopRaisedIsABoxWithTheSameFaces() {
        Solid raised = moved(BOX, top(), new Vec3(0, 0.5, 0));
        assertInstanceOf(Solid.Box.class, raised);
        assertEquals(new Aabb(0, 0, 0, 2, 2.5, 2), bounds(raised));
        assertEquals(FaceLooks.of(BOX), FaceLooks.of(raised));
        List<Vec3> raisedTop = after(top(), new Vec3(0, 0.5, 0), raised);
        assertEquals(4, raisedTop.size());
        assertTrue(raisedTop.stream().allMatch(v -> v.y() == 2.5));
        assertEquals(BOX, moved(raised, raisedTop, new Vec3(0, -0.5, 0)));
    }

    @Test
    void aShearedBoxKeepsItsVolumeAndLooks() {
        Solid sheared = moved(BOX, top(), new Vec3(0.75, 0, 0.25));
        assertEquals(8, volume(sheared), 1e-9);
        assertEquals("tile", SolidShape.towards(sheared, new Vec3(0, 1, 0)).material());
        assertTrue(SolidShape.towards(sheared, new Vec3(1, 0, 0)).portalable());
        assertAccepted(List.of(sheared));
        Solid back = moved(sheared, after(top(), new Vec3(0.75, 0, 0.25), sheared), new Vec3(-0.75, 0, -0.25));
        assertEquals(BOX, back);
    }

    @Test
    void aCornerPulledOutSplitsTheFacesAroundItIntoTriangles() {
        Solid pulled = moved(BOX, List.of(CORNER), new Vec3(0.5, 0.5, 0.5));
        List<Brush.BrushFace> faces = Brush.of(pulled).faces();
        assertEquals(9, faces.size());
        assertEquals(
                2, faces.stream().filter(face -> "tile".equals(face.material())).count());
        assertEquals(2, faces.stream().filter(Brush.BrushFace::portalable).count());
        assertTrue(rounded(VertexEdit.vertices(pulled)).contains(new Vec3(2.5, 2.5, 2.5)));
        assertAccepted(List.of(pulled));
    }

    private static List<Vec3> rounded(List<Vec3> vertices) {
        return vertices.stream().map(v -> ExactNumber.clean(v, 1e-9)).toList();
    }

    @Test
    void aVertexInsideTheOthersIsRefused() {
        assertEquals(BrushText.VERTEX_VANISHES, refusal(BOX, List.of(CORNER), new Vec3(-1.5, -1.5, -1.5)));
        assertEquals(BrushText.VERTEX_VANISHES, refusal(BOX, List.of(CORNER), new Vec3(-1, 0, -2)));
        assertEquals(BrushText.FLAT, refusal(BOX, top(), new Vec3(0, -2, 0)));
        assertTrue(VertexEdit.withVertex(BOX, new Vec3(1, 2, 1)).refusal().isPresent());
    }

    @Test
    void aVertexOnAnotherMergesWithIt() {
        Solid merged = moved(BOX, List.of(CORNER), new Vec3(0, -2, 0));
        assertEquals(7, VertexEdit.vertices(merged).size());
        assertAccepted(List.of(merged));
        List<Vec3> edge = List.of(new Vec3(0, 2, 0), new Vec3(0, 2, 2));
        assertInstanceOf(Solid.Wedge.class, moved(BOX, edge, new Vec3(0, -2, 0)));
    }

    @Test
    void anEdgeSplitInItsMiddleGetsAVertex() {
        Solid roof = VertexEdit.withVertex(BOX, new Vec3(1, 2.5, 1)).result().orElseThrow();
        assertEquals(9, VertexEdit.vertices(roof).size());
        assertEquals(8 + 2 / 3.0, volume(roof), 1e-9);
        assertEquals(
                4,
                Brush.of(roof).faces().stream()
                        .filter(face -> "tile".equals(face.material()))
                        .count());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.001, 1, 1000})
    void anyVertexCanBeMovedAndWhatIsMadeIsValid(double scale) {
        RandomSolids solids = new RandomSolids(41);
        int edits = 0;
        for (int i = 0; i < 60; i++) {
            Vec3 factors = new Vec3(scale, scale, scale);
            Optional<Solid> solid =
                    SolidTransform.scaled(solids.next(), Vec3.ZERO, factors).result();
            Vec3 by = solids.direction().scaled(0.5 * scale);
            if (solid.isPresent()) {
                List<Vec3> all = VertexEdit.vertices(solid.get());
                List<Vec3> some = all.subList(0, 1 + solids.random().nextInt(2));
                Optional<Solid> edited = VertexEdit.moved(solid.get(), some, by).result();
                edited.ifPresent(done -> assertMoved(done, some, by, scale));
                edits += edited.isPresent() ? 1 : 0;
            }
        }
        assertTrue(edits > 10, edits + " edits");
    }

    private static void assertMoved(Solid edited, List<Vec3> before, Vec3 by, double scale) {
        assertAccepted(List.of(edited));
        List<Vec3> now = VertexEdit.vertices(edited);
        for (Vec3 vertex : before) {
            Vec3 expected = vertex.plus(by);
            double nearest = now.stream()
                    .mapToDouble(v -> v.minus(expected).length())
                    .min()
                    .orElseThrow();
            assertEquals(0, nearest, 1e-5 * scale);
        }
    }

    @Test
    void allVerticesMovedMoveTheSolid() {
        RandomSolids solids = new RandomSolids(42);
        for (int i = 0; i < 40; i++) {
            Solid solid = solids.next();
            Vec3 by = solids.point(3);
            Solid edited = moved(solid, VertexEdit.vertices(solid), by);
            assertEquals(volume(solid), volume(edited), 1e-7 * volume(solid));
            assertEquals(bounds(solid).minX() + by.x(), bounds(edited).minX(), 1e-6);
        }
    }
}
