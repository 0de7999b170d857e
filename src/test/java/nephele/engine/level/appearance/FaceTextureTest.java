package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.TexturePlacement;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class FaceTextureTest {
    private static final double TEXTURE_METRES = 2;

    /** Returns a face of a box from (1, 2, 3) to (5, 4, 4). */
    private static BrushFace face(String name, TextureMapping mapping, TexturePlacement placement) {
        Solid box = new Solid.Box("b", null, false, mapping, new Vec3(3, 3, 3.5), new Vec3(4, 2, 1), Map.of());
        return Brush.of(box).faces().stream()
                .filter(face -> face.name().equals(name))
                .findFirst()
                .orElseThrow()
                .with(placement);
    }

    /** The front wall: right is +x, up is +y, so without a placement s = x / 2 and t = −y / 2. */
    private static void assertOnWall(TexturePlacement placement, double s, double t, Vec3 at) {
        assertPlace(face("+z", TextureMapping.WORLD, placement), s, t, at);
    }

    private static void assertPlace(BrushFace face, double s, double t, Vec3 at) {
        FaceTexture texture = FaceTexture.of(face, TEXTURE_METRES).unreduced();
        assertEquals(s, texture.s(at), 1e-12);
        assertEquals(t, texture.t(at), 1e-12);
    }

    @Test
    void aPictureIsShiftedToTheRightAndUpwards() {
        assertOnWall(null, 1.5, -1.25, new Vec3(3, 2.5, 4));
        assertOnWall(new TexturePlacement(0.5, 0.25, 0, 1, 1), 1.5, -1.25, new Vec3(3.5, 2.75, 4));
    }

    @Test
    void aPictureIsTurnedCounterClockwiseAboutTheOrigin() {
        assertOnWall(new TexturePlacement(0, 0, 90, 1, 1), 1.25, 1.5, new Vec3(3, 2.5, 4));
        double half = Math.sqrt(0.5);
        assertOnWall(new TexturePlacement(0, 0, 45, 1, 1), half * 5.5 / 2, half * 0.5 / 2, new Vec3(3, 2.5, 4));
    }

    @Test
    void aPictureIsScaledThenTurnedThenShifted() {
        assertOnWall(new TexturePlacement(0, 0, 0, 2, 0.5), 0.75, -2.5, new Vec3(3, 2.5, 4));
        assertOnWall(new TexturePlacement(0, 0, 0, -1, -1), -1.5, 1.25, new Vec3(3, 2.5, 4));
        assertOnWall(new TexturePlacement(1, 0.5, 90, 2, 0.5), 0.5, 2, new Vec3(3, 2.5, 4));
    }

    @Test
    void rightAndUpAreThoseSeenFromOutside() {
        TexturePlacement moved = new TexturePlacement(0.5, 0.25, 0, 1, 1);
        assertPlace(face("+y", TextureMapping.WORLD, moved), 1.25, 1.875, new Vec3(3, 4, 3.5));
        assertPlace(face("+x", TextureMapping.WORLD, moved), -2, -1.125, new Vec3(5, 2.5, 3.5));
    }

    /** With FACE mapping, the middle of the face is the pivot and its sides are the size of a repeat. */
    @Test
    void aPictureOnceOverAFaceIsTurnedAboutItsMiddle() {
        BrushFace halved = face("+z", TextureMapping.FACE, new TexturePlacement(0, 0, 0, 0.5, 0.5));
        assertPlace(halved, -0.5, 1.5, new Vec3(1, 2, 4));
        BrushFace turned = face("+z", TextureMapping.FACE, new TexturePlacement(0.5, 0, 180, 1, 1));
        assertPlace(turned, 1 + 0.5 / 4, 0, new Vec3(1, 2, 4));
        BrushFace same = face("+z", TextureMapping.FACE, TexturePlacement.NONE);
        assertPlace(same, 0, 0, new Vec3(1, 4, 4));
        assertPlace(same, 1, 1, new Vec3(5, 2, 4));
    }

    /** Normal maps need the directions in which the coordinates grow. */
    @Test
    void directionsAreThoseOfGrowth() {
        for (TexturePlacement placement : new TexturePlacement[] {
            null, new TexturePlacement(3, 4, 33, 0.7, -1.9), new TexturePlacement(0, 0, -120, -2, 0.3)
        }) {
            for (TextureMapping mapping : TextureMapping.values()) {
                FaceTexture texture = FaceTexture.of(face("-x", mapping, placement), TEXTURE_METRES);
                Vec3 p = new Vec3(1, 2.3, 3.4);
                assertEquals(1 / texture.sMetres(), texture.s(p.plus(texture.across())) - texture.s(p), 1e-12);
                assertEquals(-1 / texture.tMetres(), texture.t(p.plus(texture.up())) - texture.t(p), 1e-12);
                assertEquals(0, texture.across().dot(texture.up()), 1e-15);
                assertEquals(0, texture.s(p.plus(texture.up())) - texture.s(p), 1e-12);
            }
        }
    }

    /** A placement that changes nothing gives the same numbers, and a whole repeat the same picture. */
    @Test
    void wholeRepeatsChangeNothing() {
        FaceTexture plain = FaceTexture.of(face("-z", TextureMapping.WORLD, null), TEXTURE_METRES);
        Vec3 p = new Vec3(2.1, 3.3, 3);
        for (double repeats : new double[] {0, 1, -7}) {
            double metres = repeats * TEXTURE_METRES;
            FaceTexture moved = FaceTexture.of(
                    face("-z", TextureMapping.WORLD, new TexturePlacement(metres, -metres, 0, 1, 1)), TEXTURE_METRES);
            assertEquals(plain.s(p), moved.s(p), 1e-14);
            assertEquals(plain.t(p), moved.t(p), 1e-14);
        }
    }
}
