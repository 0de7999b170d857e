package nephele.editor.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.TexturePlacement;
import nephele.engine.math.Plane;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Execution(ExecutionMode.CONCURRENT)
class TextureFitTest {
    private static final double SAME = 1e-9;

    private final SplittableRandom random = new SplittableRandom(15);

    private Vec3 vector(double size) {
        return new Vec3(
                size * (random.nextDouble() - 0.5),
                size * (random.nextDouble() - 0.5),
                size * (random.nextDouble() - 0.5));
    }

    private TexturePlacement placement() {
        return new TexturePlacement(
                random.nextDouble() * 4 - 2,
                random.nextDouble() * 4 - 2,
                random.nextDouble() * 720 - 360,
                (random.nextBoolean() ? 1 : -1) * (0.2 + random.nextDouble() * 3),
                (random.nextBoolean() ? 1 : -1) * (0.2 + random.nextDouble() * 3));
    }

    private Brush brush(TextureMapping mapping) {
        Vec3 size = new Vec3(0.3 + random.nextDouble() * 6, 0.3 + random.nextDouble() * 6, 1 + random.nextDouble());
        Vec3 centre = vector(200);
        return Brush.of(
                switch (random.nextInt(3)) {
                    case 0 -> new Solid.Box("b", null, false, mapping, centre, size, Map.of());
                    case 1 -> new Solid.Wedge("w", null, false, mapping, centre, size, BoxFace.PLUS_X, Map.of());
                    default -> new Solid.Prism("p", null, false, mapping, centre, size.x(), size.y(), 7, Map.of());
                });
    }

    private List<PaintedFace> faces(int brushes, TextureMapping mapping) {
        List<PaintedFace> faces = new ArrayList<>();
        for (int i = 0; i < brushes; i++) {
            for (BrushFace face : brush(mapping).faces()) {
                faces.add(new PaintedFace(face.with(placement()), 0.5 + random.nextDouble() * 3));
            }
        }
        return faces;
    }

    private static void assertSamePicture(
            TextureFit.TextureCoordinates wanted, TextureFit.TextureCoordinates got, String about) {
        double u = wanted.u() - got.u();
        double v = wanted.v() - got.v();
        assertEquals(0, u - Math.rint(u), SAME, about);
        assertEquals(0, v - Math.rint(v), SAME, about);
    }

    private static double[] span(PaintedFace face) {
        double[] span = {1e9, -1e9, 1e9, -1e9};
        for (Vec3 corner : face.face().polygon()) {
            TextureFit.TextureCoordinates at = TextureFit.uvAt(face, corner);
            span[0] = Math.min(span[0], at.u());
            span[1] = Math.max(span[1], at.u());
            span[2] = Math.min(span[2], at.v());
            span[3] = Math.max(span[3], at.v());
        }
        return span;
    }

    @ParameterizedTest
    @EnumSource(TextureMapping.class)
    void aFittedPictureSpansItsRepeats(TextureMapping mapping) {
        for (PaintedFace face : faces(30, mapping)) {
            double across = 1 + random.nextInt(4);
            double above = random.nextBoolean() ? 1 : 2.5;
            double[] span = span(face.with(TextureFit.fit(face, across, above)));
            assertEquals(0, span[0] - Math.rint(span[0]), SAME);
            assertEquals(across, span[1] - span[0], SAME);
            assertEquals(0, span[2] - Math.rint(span[2]), SAME);
            assertEquals(above, span[3] - span[2], SAME);
        }
    }

    @Test
    void aWallIsFittedInPlainNumbers() {
        Solid wall = new Solid.Box(
                "w", "m", false, TextureMapping.WORLD, new Vec3(2.76, 1.25, -1), new Vec3(1.7, 2.5, 0.3), Map.of());
        Material material = new Material("m", Vec3.ZERO, null, null, null, null, Vec3.ZERO, 2);
        BrushFace front = Brush.of(wall).faces().get(4);
        assertEquals(new TexturePlacement(0.21, 0, 0, 0.85, 1.25), TextureFit.fit(front, material, 1, 1));
        assertEquals(new TexturePlacement(0.21, 0, 0, 0.425, 0.625), TextureFit.fit(front, material, 2, 2));
        BrushFace turned = front.with(new TexturePlacement(0, 0, 90, 1, 1));
        assertEquals(90, TextureFit.fit(turned, material, 1, 1).rotationDegrees());
        assertEquals(1.25, TextureFit.fit(turned, material, 1, 1).scaleU());
    }

    @ParameterizedTest
    @EnumSource(TextureAlignment.class)
    void anAlignedPictureLiesAtItsEdge(TextureAlignment alignment) {
        double fraction = alignment.fraction();
        int axis = alignment.isHorizontal() ? 0 : 2;
        for (PaintedFace face : faces(10, TextureMapping.WORLD)) {
            TexturePlacement aligned = TextureFit.align(face, alignment);
            double[] span = span(face.with(aligned));
            double place = span[axis] + fraction * (span[axis + 1] - span[axis]) - fraction;
            assertEquals(0, place - Math.rint(place), SAME);
            double other = span[2 - axis] - span(face)[2 - axis];
            assertEquals(0, other - Math.rint(other), SAME, "the other direction stays");
            assertEquals(face.placement().scaleU(), aligned.scaleU(), 1e-10);
        }
    }

    @ParameterizedTest
    @EnumSource(TextureMapping.class)
    void aLockedPictureMovesWithItsFace(TextureMapping mapping) {
        for (PaintedFace face : faces(60, mapping)) {
            RigidMove move = new RigidMove(turn(face), vector(50), vector(50));
            PaintedFace there = moved(face, move);
            PaintedFace after = there.with(TextureFit.locked(face, there, move));
            for (Vec3 corner : face.face().polygon()) {
                Vec3 now = move.point(corner);
                assertSamePicture(TextureFit.uvAt(face, corner), TextureFit.uvAt(after, now), move.toString());
            }
            assertEquals(face.placement().scaleU() < 0, after.placement().scaleU() < 0, "stays mirrored as it was");
        }
    }

    /** Returns no turn, quarter turns about an axis, a turn about the normal, or any. */
    private Quaterniond turn(PaintedFace face) {
        Vec3 axis = BoxFace.values()[random.nextInt(6)].normal();
        double quarter = Math.PI / 2 * random.nextInt(4);
        return switch (random.nextInt(4)) {
            case 0 -> new Quaterniond();
            case 1 -> Rotations.aroundAxis(axis, quarter);
            case 2 -> Rotations.aroundAxis(face.face().plane().normal(), 6 * random.nextDouble());
            default -> Rotations.aroundAxis(vector(1), 6 * random.nextDouble());
        };
    }

    private static PaintedFace moved(PaintedFace painted, RigidMove move) {
        BrushFace face = painted.face();
        List<Vec3> polygon =
                face.polygon().stream().map(corner -> move.point(corner)).toList();
        Vec3 normal = move.direction(face.plane().normal());
        return new PaintedFace(
                new BrushFace(
                        face.name(),
                        Plane.through(normal, polygon.get(0)),
                        polygon,
                        null,
                        false,
                        face.textureMapping(),
                        null),
                painted.textureMetres());
    }

    @Test
    void aPictureContinuesAroundEveryEdgeWithoutASeam() {
        int edges = 0;
        for (int i = 0; i < 40; i++) {
            List<BrushFace> faces = brush(TextureMapping.values()[i % 2]).faces();
            PaintedFace from =
                    new PaintedFace(faces.get(random.nextInt(faces.size())).with(placement()), 1.5);
            for (BrushFace other : faces) {
                List<Vec3> shared = new ArrayList<>(other.polygon());
                shared.removeIf(corner -> from.face().polygon().stream()
                        .noneMatch(mine -> mine.minus(corner).length() < 1e-9));
                if (shared.size() != 2) {
                    continue;
                }
                edges++;
                PaintedFace to = new PaintedFace(other, 1.5);
                PaintedFace painted = to.with(TextureFit.continued(from, to));
                for (double share : new double[] {0, 0.37, 1}) {
                    Vec3 p = shared.get(0).lerp(shared.get(1), share);
                    assertSamePicture(TextureFit.uvAt(from, p), TextureFit.uvAt(painted, p), other.name());
                }
                assertUnfolds(from, painted, shared);
            }
        }
        assertTrue(edges > 100, edges + " edges");
    }

    /** Into the other face, the picture goes on as it does out of the first one. */
    private static void assertUnfolds(PaintedFace from, PaintedFace to, List<Vec3> edge) {
        Vec3 along = edge.get(1)
                .minus(edge.get(0))
                .scaled(1 / edge.get(1).minus(edge.get(0)).length());
        Vec3 outOf = along.cross(from.face().plane().normal());
        Vec3 into = along.cross(to.face().plane().normal());
        double side = Math.signum(outOf.dot(edge.get(0).minus(from.middle())));
        double otherSide = Math.signum(into.dot(to.middle().minus(edge.get(0))));
        assertSamePicture(
                TextureFit.uvAt(from, edge.get(0).addScaled(side, outOf)),
                TextureFit.uvAt(to, edge.get(0).addScaled(otherSide, into)),
                to.face().name());
    }

    /** Continues a placement across the inner edge of a corner. */
    @Test
    void aPictureContinuesFromTheFloorUpAWall() {
        List<BrushFace> floor = box(new Vec3(0, -0.5, 0), new Vec3(4, 1, 4));
        List<BrushFace> wall = box(new Vec3(2.5, 2, 0), new Vec3(1, 4, 4));
        PaintedFace from = new PaintedFace(floor.get(2).with(new TexturePlacement(0.3, 0.2, 15, 1, 2)), 1);
        PaintedFace to = new PaintedFace(wall.get(1), 1);
        PaintedFace painted = to.with(TextureFit.continued(from, to));
        assertSamePicture(
                TextureFit.uvAt(from, new Vec3(3.25, 0, 1)), TextureFit.uvAt(painted, new Vec3(2, 1.25, 1)), "wall");
    }

    @Test
    void aPictureContinuesOnAFaceInTheSamePlaneAndRepeatsOnAnOppositeOne() {
        List<BrushFace> left = box(new Vec3(0, 0, 0), new Vec3(1, 1, 1));
        List<BrushFace> right = box(new Vec3(1, 0.3, 0), new Vec3(1, 2, 1));
        PaintedFace from = new PaintedFace(left.get(4).with(placement()), 1);
        PaintedFace to = new PaintedFace(right.get(4), 1);
        Vec3 p = new Vec3(0.7, 0.1, 0.5);
        assertSamePicture(
                TextureFit.uvAt(from, p), TextureFit.uvAt(to.with(TextureFit.continued(from, to)), p), "beside");
        assertEquals(from.placement(), TextureFit.continued(from, new PaintedFace(right.get(5), 1)));
    }

    private static List<BrushFace> box(Vec3 centre, Vec3 size) {
        return Brush.of(new Solid.Box("b", null, false, TextureMapping.WORLD, centre, size, Map.of()))
                .faces();
    }
}
