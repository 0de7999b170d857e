package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Directions read the right texels of a skybox: adjacent faces join, and a cross equals the unfolded faces. */
class SkyboxPicturesTest {
    private static final double[] LINEAR = ColourDecoding.SRGB.table();
    private static final List<String> FILES = Stream.of("px", "nx", "py", "ny", "pz", "nz")
            .map(face -> "textures/sky-bay-" + face + ".png")
            .toList();

    /** A continuous sky has no step at any of the twelve edges; a mirrored or rotated face would make one. */
    @Test
    void theSkyOverTheBayIsContinuousAcrossAllEdges() {
        SkyboxPictures sky = SkyboxPictures.of(new Sky.Skybox(SkyboxLayout.FACES, FILES), SkyboxPicturesTest::picture);
        for (int edge = 0; edge < 12; edge++) {
            double sum = 0;
            for (int i = 0; i < 100; i++) {
                double along = (i + 0.5) / 50 - 1;
                sum += at(sky, onEdge(edge, along, 0.999)).distance(at(sky, onEdge(edge, along, 1.001)));
            }
            assertEquals(0, sum / 100, 0.03, "edge " + edge);
        }
    }

    /** An editor shows levels that no check has seen. */
    @Test
    void anotherNumberOfFilesIsRefused() {
        for (SkyboxLayout layout : SkyboxLayout.values()) {
            Sky.Skybox sky = new Sky.Skybox(layout, List.of());
            assertThrows(IllegalArgumentException.class, () -> SkyboxPictures.of(sky, SkyboxPicturesTest::picture));
        }
    }

    @Test
    void aCrossIsTheFacesUnfolded() {
        SkyboxPictures faces =
                SkyboxPictures.of(new Sky.Skybox(SkyboxLayout.FACES, FILES), SkyboxPicturesTest::picture);
        SkyboxPictures cross = SkyboxPictures.of(
                new Sky.Skybox(SkyboxLayout.CROSS, List.of("textures/sky-bay-cross.png")), SkyboxPicturesTest::picture);
        double sum = 0;
        for (int i = 0; i < 500; i++) {
            double y = 1 - (i + 0.5) / 250;
            double turn = i * 2.399963;
            double flat = Math.sqrt(1 - y * y);
            Vector3d direction = new Vector3d(flat * StrictMath.cos(turn), y, flat * StrictMath.sin(turn));
            sum += at(faces, direction).distance(at(cross, direction));
        }
        assertEquals(0, sum / 500, 0.02);
    }

    /**
     * Returns a direction near the edge of two axes; {@code first} over 1 is on the first one's face, under 1 on the
     * other's.
     */
    private static Vector3d onEdge(int edge, double along, double first) {
        double[] v = new double[3];
        int free = edge / 4;
        v[free] = along;
        v[(free + 1) % 3] = (edge & 1) == 0 ? first : -first;
        v[(free + 2) % 3] = (edge & 2) == 0 ? 1 : -1;
        return new Vector3d(v[0], v[1], v[2]);
    }

    private static Vector3d at(SkyboxPictures sky, Vector3d direction) {
        return sky.radiance(LINEAR, direction.x, direction.y, direction.z);
    }

    private static Picture picture(String id) {
        try {
            return PictureDecoder.decode(id, Files.readAllBytes(Path.of("assets", id)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
