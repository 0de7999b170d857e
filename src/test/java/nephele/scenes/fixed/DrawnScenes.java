package nephele.scenes.fixed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.scenes.fixed.FixedSceneDrawing.Source;
import nephele.scenes.fixed.FixedSceneDrawing.Sources;
import nephele.scenes.xml.XmlSceneFile;
import org.joml.Matrix4d;

/** Draws small pictures of scenes that are written in tests; every frame is checked for OpenGL errors. */
final class DrawnScenes implements AutoCloseable {
    static final int SIZE = 128;

    final GlContext gl = GlContext.offscreen();
    final RenderTarget picture = RenderTarget.picture(gl, "test picture", PixelFormat.RGBA8, SIZE, SIZE);

    /** Warnings about what cannot be shown. */
    final List<String> complaints = new ArrayList<>();

    private final Map<String, byte[]> files;

    DrawnScenes() {
        this(Map.of());
    }

    /** @param files files beside the scenes */
    DrawnScenes(Map<String, byte[]> files) {
        this.files = files;
    }

    /** Returns a world with the camera 3 units before the origin, 60° high. */
    static String world(String lightsAndGroups) {
        return "<world><camera><position x='0' y='0' z='3'/><lookAt x='0' y='0' z='0'/><up x='0' y='1' z='0'/>"
                + "<projection fov='60' near='1' far='100'/></camera>" + lightsAndGroups + "</world>";
    }

    Source source(String xml) {
        byte[] utf8 = xml.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
        AssetSource assets = new AssetSource() {
            @Override
            public byte[] bytes(String assetId) {
                if (!exists(assetId)) {
                    throw new AssetException(assetId, "there is no such file", "add it");
                }
                return files.get(assetId);
            }

            @Override
            public boolean exists(String assetId) {
                return files.containsKey(assetId);
            }
        };
        var scene = XmlSceneFile.read("test.xml", utf8);
        assertEquals(List.of(), scene.warnings());
        return new Source(scene, new SceneFolder("test.xml", assets, complaints::add));
    }

    /** Returns 0xrrggbb, the bottom row first. */
    int[] pixels(String xml, SceneAppearance look) {
        return pixels(new Sources(source(xml), null, null), look);
    }

    int[] pixels(Sources sources, SceneAppearance look) {
        try (var drawing = FixedSceneDrawing.load(gl, sources)) {
            draw(drawing, sources, look, 0);
            return pixels();
        }
    }

    /** Draws with the entity 3 units along z. */
    void draw(FixedSceneDrawing drawing, Sources sources, SceneAppearance look, double seconds) {
        var view = FixedSceneDrawing.view(sources.scene().scene().eye(), 1);
        drawing.draw(view, seconds, new Matrix4d().translation(0, 0, 3), look, picture);
        gl.requireNoError("scene");
    }

    int[] pixels() {
        ByteBuffer bytes = picture.readBytes();
        int[] rgb = new int[SIZE * SIZE];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (bytes.get(4 * i) & 0xff) << 16 | (bytes.get(4 * i + 1) & 0xff) << 8 | bytes.get(4 * i + 2) & 0xff;
        }
        return rgb;
    }

    static int centre(int[] pixels) {
        return pixels[SIZE / 2 * SIZE + SIZE / 2];
    }

    static long drawn(int[] pixels) {
        return java.util.Arrays.stream(pixels).filter(rgb -> rgb != 0).count();
    }

    static int channel(int rgb, int number) {
        return rgb >> 16 - 8 * number & 0xff;
    }

    /** Returns a picture of one colour. */
    static Picture plain(int rgb) {
        byte[] samples = {(byte) (rgb >> 16), (byte) (rgb >> 8), (byte) rgb};
        return new Picture(1, 1, 3, 8, samples);
    }

    @Override
    public void close() {
        picture.close();
        gl.close();
    }
}
