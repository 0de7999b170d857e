package nephele.engine.render.gl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.Map;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.DrawState.Stencil;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Volumes, drawn layers, reduced targets, blending and partial updates have the expected content. */
class LayersGlTest {
    private static final String COVER = "void main() {\n"
            + "    vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
            + "    gl_Position = vec4(at, 0.0, 1.0);\n}\n";

    private static ByteBuffer bytes(int... values) {
        ByteBuffer all = ByteBuffer.allocateDirect(values.length).order(ByteOrder.nativeOrder());
        for (int value : values) {
            all.put((byte) value);
        }
        return all.flip();
    }

    private static ShaderSource source(String name, String text) {
        return new ShaderSource("/" + name, Map.of(), path -> text);
    }

    /** Covers the bound target with the value that the fragment shader's {@code main} writes to {@code shown}. */
    private static void cover(GlContext gl, Blend blend, String declared, String expression, TextureUnit unit) {
        String text = declared + "out vec4 shown;\nvoid main() { shown = " + expression + "; }\n";
        var program = new GlProgram<>(gl, source("cover.vert", COVER), source("cover.frag", text), u -> u);
        try (var triangle = new FullScreenTriangle(gl, "cover")) {
            program.use();
            if (unit != null) {
                program.uniforms().sampler("source", unit);
            }
            gl.state().set(Depth.OFF, blend, Cull.NONE);
            triangle.draw();
        }
        gl.requireNoError("cover");
    }

    private static int[] firstTexel(RenderTarget target) {
        ByteBuffer all = target.readBytes();
        return new int[] {all.get(0) & 0xff, all.get(1) & 0xff, all.get(2) & 0xff, all.get(3) & 0xff};
    }

    /** A clear obeys the stencil's mask: it empties the stencil also after a test that leaves it as it is. */
    @Test
    void aClearEmptiesTheStencil() {
        try (GlContext gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "shown", PixelFormat.RGBA8, 1, 1)) {
            target.clear(0, 0, 0);
            gl.state().stencil(Stencil.EQUAL_COUNT_UP, 0);
            cover(gl, Blend.REPLACE, "", "vec4(0.2)", null);
            gl.state().stencil(Stencil.EQUAL, 1);
            cover(gl, Blend.REPLACE, "", "vec4(0.4)", null);
            assertEquals(102, firstTexel(target)[0]);
            gl.state().stencil(Stencil.OFF, 0);
            target.clear(0, 0, 0);
            gl.state().stencil(Stencil.EQUAL, 0);
            cover(gl, Blend.REPLACE, "", "vec4(0.6)", null);
            assertEquals(153, firstTexel(target)[0]);
        }
    }

    /** Half-way between slices of 0 and 200 the value is 100, and the slices repeat. */
    @ParameterizedTest
    @CsvSource({"0.5, 100", "0.25, 0", "0.75, 200", "1.25, 0", "1.0, 100"})
    void volumeIsFilteredBetweenItsSlices(String depth, int expected) {
        Texture.Extent extent = new Texture.Extent(2, 2, 2);
        try (GlContext gl = GlContext.offscreen();
                var volume = new Texture(
                        gl, "volume", Texture.Shape.VOLUME, PixelFormat.R8, extent, Sampling.LINEAR_REPEAT);
                var target = RenderTarget.picture(gl, "shown", PixelFormat.RGBA8, 1, 1)) {
            volume.upload(0, bytes(0, 0, 0, 0));
            volume.upload(1, bytes(200, 200, 200, 200));
            volume.bind(TextureUnit.COLOURS);
            target.bind();
            cover(
                    gl,
                    Blend.REPLACE,
                    "uniform sampler3D source;\n",
                    "texture(source, vec3(0.5, 0.5, " + depth + "))",
                    TextureUnit.COLOURS);
            assertEquals(expected, firstTexel(target)[0], 1);
        }
    }

    /** Each layer or slice is drawn separately. */
    @ParameterizedTest
    @EnumSource(
            value = Texture.Shape.class,
            names = {"ARRAY", "VOLUME"})
    void layersAreDrawnIntoOneByOne(Texture.Shape shape) {
        Texture.Extent extent = new Texture.Extent(4, 4, 3);
        try (GlContext gl = GlContext.offscreen();
                var layers = new Texture(gl, "layers", shape, PixelFormat.RGBA8, extent, Sampling.NEAREST_CLAMP)) {
            for (int i = 0; i < 3; i++) {
                try (var target = RenderTarget.colourLayer(gl, "layer " + i, layers, i)) {
                    target.bind();
                    cover(gl, Blend.REPLACE, "", "vec4(" + i + " == 1, " + i + " == 2, 0.2, 1.0)", null);
                }
            }
            for (int i = 0; i < 3; i++) {
                try (var target = RenderTarget.colourLayer(gl, "layer " + i, layers, i)) {
                    assertArrayEquals(new int[] {i == 1 ? 255 : 0, i == 2 ? 255 : 0, 51, 255}, firstTexel(target));
                }
            }
            gl.requireNoError("layers");
        }
    }

    @Test
    void volumeBeyondTheLimitSaysRequiredAndFound() {
        try (GlContext gl = GlContext.offscreen()) {
            Texture.Extent huge = new Texture.Extent(1, 1, gl.limits().maxVolumeSize() + 1);
            var e = assertThrows(
                    GlUnavailableException.class,
                    () -> new Texture(gl, "huge", Texture.Shape.VOLUME, PixelFormat.R8, huge, Sampling.LINEAR_REPEAT));
            assertTrue(e.getMessage().contains("requires") && e.getMessage().contains("allows"), e.getMessage());
        }
    }

    /** Sizes are rounded up, so that the reduced picture covers all of the full one; no side is empty. */
    @ParameterizedTest
    @CsvSource({"2, 7, 3, 4, 2", "4, 7, 3, 2, 1", "4, 1, 1, 1, 1", "2, 8, 6, 4, 3"})
    void reducedTargetsCoverTheFullOne(int divisor, int width, int height, int itsWidth, int itsHeight) {
        try (GlContext gl = GlContext.offscreen();
                var full = RenderTarget.picture(gl, "full", PixelFormat.RGBA8, width, height);
                var part = full.reduced("part", PixelFormat.RGBA16F, divisor)) {
            assertEquals(itsWidth, part.width());
            assertEquals(itsHeight, part.height());
            assertEquals(Sampling.LINEAR_CLAMP, part.colour().sampling());
        }
    }

    /** Blending of (0.4, 0.2, 0, 0.6) with (0.2, 0.2, 0.2, 0.4), colours and alpha in 255ths. */
    @ParameterizedTest
    @CsvSource({
        "REPLACE, 102, 51, 0, 153",
        "OVER, 82, 51, 20, 102",
        "ADD, 153, 102, 51, 102",
        "PREMULTIPLIED_OVER, 122, 71, 20, 194"
    })
    void fragmentsJoinWhatIsThere(Blend blend, int red, int green, int blue, int alpha) {
        try (GlContext gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 2, 2)) {
            target.clearTransparent();
            assertArrayEquals(new int[4], firstTexel(target));
            cover(gl, Blend.REPLACE, "", "vec4(0.2, 0.2, 0.2, 0.4)", null);
            cover(gl, blend, "", "vec4(0.4, 0.2, 0.0, 0.6)", null);
            int[] is = firstTexel(target);
            int[] wanted = {red, green, blue, alpha};
            for (int i = 0; i < 4; i++) {
                assertEquals(wanted[i], is[i], 1, "channel " + i);
            }
        }
    }

    /** A part of a flat texture and of a layer is replaced; the rest stays. */
    @Test
    void partsOfTexturesAreReplaced() {
        try (GlContext gl = GlContext.offscreen();
                var target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 4, 4)) {
            target.clear(0, 0, 0);
            target.colour().upload(0, new Texture.Region(1, 2, 2, 1), bytes(9, 8, 7, 6, 5, 4, 3, 2));
            ByteBuffer all = target.readBytes();
            for (int i = 0; i < 64; i++) {
                int inPart = i - 4 * (2 * 4 + 1);
                int wanted = inPart >= 0 && inPart < 8 ? 9 - inPart : i % 4 == 3 ? 255 : 0;
                assertEquals(wanted, all.get(i) & 0xff, "byte " + i);
            }
        }
    }

    @Test
    void partsOfListsAreReplaced() {
        try (GlContext gl = GlContext.offscreen();
                var list = BufferTexture.ofFloats(gl, "list", new float[] {1, 1, 1, 1, 1, 0, 0, 1});
                var target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 2, 1)) {
            FloatBuffer green =
                    ByteBuffer.allocateDirect(16).order(ByteOrder.nativeOrder()).asFloatBuffer();
            list.uploadFrom(1, green.put(new float[] {0, 1, 0, 1}).flip());
            list.bind(TextureUnit.PUNCTUAL_LIGHTS);
            target.bind();
            cover(
                    gl,
                    Blend.REPLACE,
                    "uniform samplerBuffer source;\n",
                    "texelFetch(source, int(gl_FragCoord.x))",
                    TextureUnit.PUNCTUAL_LIGHTS);
            assertEquals(bytes(255, 255, 255, 255, 0, 255, 0, 255), target.readBytes());
        }
    }

    /** A triangle outside the picture is moved over all of it. */
    @Test
    void partsOfVerticesAreReplaced() {
        ByteBuffer corners = ByteBuffer.allocateDirect(36).order(ByteOrder.nativeOrder());
        for (int i = 0; i < 9; i++) {
            corners.putFloat(5);
        }
        IntBuffer order =
                ByteBuffer.allocateDirect(12).order(ByteOrder.nativeOrder()).asIntBuffer();
        order.put(new int[] {0, 1, 2}).flip();
        VertexFormat format = VertexFormat.of(VertexFormat.Attribute.FLOAT3);
        ShaderSource vertex =
                source("at.vert", "layout(location = 0) in vec3 at;\nvoid main() { gl_Position = vec4(at, 1.0); }\n");
        ShaderSource fragment =
                source("red.frag", "out vec4 shown;\nvoid main() { shown = vec4(1.0, 0.0, 0.0, 1.0); }\n");
        try (GlContext gl = GlContext.offscreen();
                var mesh = new GpuMesh(gl, "mesh", format, corners.flip(), order);
                var target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 1, 1)) {
            var program = new GlProgram<>(gl, vertex, fragment, u -> u);
            target.clear(0, 0, 0);
            gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
            program.use();
            mesh.draw(0, 3);
            assertEquals(0, firstTexel(target)[0]);
            float[] over = {-1, -1, 0, 3, -1, 0, -1, 3, 0};
            ByteBuffer one = ByteBuffer.allocateDirect(12).order(ByteOrder.nativeOrder());
            for (int corner = 0; corner < 3; corner++) {
                one.clear();
                for (int i = 0; i < 3; i++) {
                    one.putFloat(over[3 * corner + i]);
                }
                mesh.replaceVertices(12L * corner, one.flip());
            }
            mesh.draw(0, 3);
            assertEquals(255, firstTexel(target)[0]);
        }
    }
}
