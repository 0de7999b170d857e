package nephele.editor.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import java.util.Map;
import nephele.editor.paint.PaintedFace;
import nephele.editor.paint.TextureFit;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Execution(ExecutionMode.CONCURRENT)
class LockableTransformTest {
    private static final List<Material> MATERIALS =
            List.of(picture("brick", 0.75), picture("tile", 1.5), picture("metal", 2));
    private static final LockableTransform LOCKED = LockableTransform.of(true, MATERIALS);
    private static final TexturePlacement PLACEMENT = new TexturePlacement(0.25, -0.5, 20, -0.5, 2);

    private static final Vec3 PIECE = new Vec3(0.125, 0, 0);

    private static Material picture(String id, double metres) {
        return new Material(id, new Vec3(1, 1, 1), id + ".png", null, null, null, Vec3.ZERO, metres);
    }

    private static PaintedFace painted(BrushFace face) {
        return PaintedFace.of(
                face,
                MATERIALS.stream()
                        .filter(material -> material.id().equals(face.material()))
                        .findFirst()
                        .orElse(null));
    }

    /** Returns a solid of which every second face has a placement. */
    private static Solid next(RandomSolids solids) {
        Solid solid = FaceLooks.withMaterial(solids.next(), 1, "tile");
        Solid placed = solid.material() == null ? FaceLooks.withMaterial(solid, "brick") : solid;
        List<String> names = SolidFaces.names(placed);
        for (int i = 0; i < names.size(); i += 2) {
            Solid.Face said = SolidFaces.authored(placed, names.get(i));
            placed = SolidFaces.with(
                    placed, names.get(i), new Solid.Face(said.material(), said.portalable(), PLACEMENT));
        }
        return placed;
    }

    private static void assertSamePictures(Solid before, Solid after, LockedMove move) {
        for (BrushFace face : Brush.of(before).faces()) {
            Vec3 inside = move.point(SolidShape.bounds(before).centre());
            Vec3 normal = move.point(
                            SolidShape.bounds(before).centre().plus(face.plane().normal()))
                    .minus(inside);
            BrushFace moved = SolidShape.towards(after, normal);
            for (Vec3 corner : face.polygon()) {
                TextureFit.TextureCoordinates uv = TextureFit.uvAt(painted(face), corner);
                TextureFit.TextureCoordinates now = TextureFit.uvAt(painted(moved), move.point(corner));
                assertEquals(0, uv.u() - now.u() - Math.rint(uv.u() - now.u()), 1e-6, face + " of " + before);
                assertEquals(0, uv.v() - now.v() - Math.rint(uv.v() - now.v()), 1e-6, face + " of " + before);
            }
        }
    }

    @Test
    void aLockedMoveKeepsThePictureAtEachCorner() {
        RandomSolids solids = new RandomSolids(90);
        for (int i = 0; i < 40; i++) {
            Solid solid = next(solids);
            Vec3 by = solids.direction().scaled(30);
            Solid moved = LOCKED.moved(solid, by);
            assertSamePictures(solid, moved, LockedMove.shift(by));
            assertEquals(solid.getClass(), moved.getClass());
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 1, 0, 90", "0, 1, 0, 180", "1, 0, 0, -90", "0, 0, 1, 270", "0, 1, 0, 30", "1, 2, -3, 77"})
    void aLockedTurnKeepsThePictureAtEachCorner(double x, double y, double z, double degrees) {
        RandomSolids solids = new RandomSolids(91);
        Vec3 axis = new Vec3(x, y, z);
        for (int i = 0; i < 20; i++) {
            Solid solid = next(solids);
            Vec3 pivot = solids.point(3);
            Solid turned = LOCKED.rotated(solid, pivot, axis, degrees).result().orElseThrow();
            assertSamePictures(solid, turned, LockedMove.turn(pivot, axis, degrees));
        }
    }

    @Test
    void withoutTheLockPlacementsStayAsTheyAre() {
        LockableTransform world = LockableTransform.of(false, MATERIALS);
        RandomSolids solids = new RandomSolids(92);
        Vec3 up = new Vec3(0, 1, 0);
        for (int i = 0; i < 20; i++) {
            Solid solid = next(solids);
            assertEquals(SolidTransform.moved(solid, up), world.moved(solid, up));
            assertEquals(SolidTransform.rotated(solid, up, up, 30), world.rotated(solid, up, up, 30));
        }
    }

    @Test
    void aMoveByWholeRepeatsWritesNoPlacement() {
        Solid.Box box = SolidShape.box("b", Vec3.ZERO, new Vec3(1, 1, 1));
        Vec3 repeats = new Vec3(1.5, -0.75, 3);
        assertEquals(SolidTransform.moved(box, repeats), LOCKED.moved(box, repeats));
        assertNotEquals(SolidTransform.moved(box, PIECE), LOCKED.moved(box, PIECE));
    }

    @Test
    void plainFacesGetNoPlacement() {
        Solid.Box grey = new Solid.Box("b", null, false, TextureMapping.WORLD, Vec3.ZERO, new Vec3(1, 1, 1), Map.of());
        assertEquals(SolidTransform.moved(grey, PIECE), LOCKED.moved(grey, PIECE));
        Solid tiled = SolidFaces.with(grey, "+z", new Solid.Face("tile", null, null));
        Solid.Box moved = (Solid.Box) LOCKED.moved(tiled, PIECE);
        assertEquals(
                Map.of(BoxFace.PLUS_Z, new Solid.Face("tile", null, new TexturePlacement(0.125, 0, 0, 1, 1))),
                moved.faces());
    }

    @Test
    void nothingChangesWithoutAMove() {
        Solid solid = next(new RandomSolids(93));
        assertEquals(solid, LOCKED.moved(solid, Vec3.ZERO));
        assertEquals(solid, LOCKED.rotated(solid, PIECE, PIECE, 360).result().orElseThrow());
    }
}
