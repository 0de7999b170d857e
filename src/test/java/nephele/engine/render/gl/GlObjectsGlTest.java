package nephele.engine.render.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import nephele.engine.render.gl.shader.GlException;
import nephele.engine.render.gl.shader.ShaderSource;
import org.junit.jupiter.api.Test;

/** Errors of this layer have clear messages, and objects are counted. */
class GlObjectsGlTest {
    private static final String VERTEX = "uniform vec3 offset;\nvoid main() { gl_Position = vec4(offset, 1.0); }\n";

    private static ShaderSource source(String name, String text) {
        return new ShaderSource("/" + name, Map.of(), path -> text);
    }

    @Test
    void aCompileErrorNamesFileAndLine() {
        try (GlContext gl = GlContext.offscreen()) {
            var before = gl.live().counts();
            ShaderSource wrong = source("wrong.frag", "// one\n// two\nvoid main() { nonsense; }\n");
            GlException e =
                    assertThrows(GlException.class, () -> new GlProgram<>(gl, source("a.vert", VERTEX), wrong, u -> u));
            assertTrue(e.getMessage().contains("wrong.frag:3"), e.getMessage());
            assertEquals(before, gl.live().counts());
        }
    }

    /**
     * A file included twice counts once, for the compiler; also if the first inclusion is in a branch that is not
     * taken.
     */
    @Test
    void anIncludeCountsOnceWhereTheCompilerSeesIt() {
        Map<String, String> files = Map.of(
                "/two.frag",
                "#ifdef ABSENT\n#include \"one.glsl\"\n#endif\n#include \"one.glsl\"\n#include \"one.glsl\"\n"
                        + "void main() { one(); wrong; }\n",
                "/nephele/engine/render/include/one.glsl",
                "void one() {}\n");
        try (GlContext gl = GlContext.offscreen()) {
            ShaderSource fragment = new ShaderSource("/two.frag", Map.of(), files::get);
            GlException e = assertThrows(
                    GlException.class, () -> new GlProgram<>(gl, source("a.vert", VERTEX), fragment, u -> u));
            assertTrue(e.getMessage().contains("two.frag:6"), e.getMessage());
            assertFalse(e.getMessage().contains("one.glsl"), e.getMessage());
            assertFalse(e.getMessage().contains("one'"), e.getMessage());
        }
    }

    @Test
    void aMissingUniformIsNamed() {
        try (GlContext gl = GlContext.offscreen()) {
            ShaderSource fragment = source("a.frag", "void main() {}\n");
            GlException e = assertThrows(
                    GlException.class,
                    () -> new GlProgram<>(gl, source("a.vert", VERTEX), fragment, u -> u.vector3("sunDirection")));
            assertTrue(e.getMessage().contains("'sunDirection'"), e.getMessage());
        }
    }

    @Test
    void newerGlslIsRefused() {
        try (GlContext gl = GlContext.offscreen()) {
            ShaderSource newer = source("n.frag", "layout(std430) buffer B { float b[]; };\nvoid main() {}\n");
            assertThrows(GlException.class, () -> new GlProgram<>(gl, source("a.vert", VERTEX), newer, u -> u));
        }
    }

    @Test
    void aTextureBeyondTheLimitSaysRequiredAndFound() {
        try (GlContext gl = GlContext.offscreen()) {
            int tooLarge = gl.limits().maxTextureSize() + 1;
            GlUnavailableException e = assertThrows(
                    GlUnavailableException.class,
                    () -> RenderTarget.picture(gl, "huge", PixelFormat.RGBA8, tooLarge, 1));
            assertTrue(e.getMessage().contains("requires") && e.getMessage().contains("allows"), e.getMessage());
        }
    }

    @Test
    void aHandleIsClosedOnce() {
        try (GlContext gl = GlContext.offscreen()) {
            AtomicInteger deleted = new AtomicInteger();
            GlHandle handle = new GlHandle(gl, GlKind.QUERY, "q", 7, deleted::set);
            assertEquals(1, gl.live().counts().get(GlKind.QUERY));
            handle.close();
            assertEquals(7, deleted.get());
            assertEquals(0, gl.live().counts().get(GlKind.QUERY));
            assertThrows(GlException.class, handle::close);
            assertThrows(GlException.class, handle::id);
        }
    }

    /** A texture that receives the name of a closed one is bound again. */
    @Test
    void aReusedNameIsBoundAgain() {
        try (GlContext gl = GlContext.offscreen();
                RenderTarget target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 4, 4)) {
            for (int i = 0; i < 3; i++) {
                try (RenderTarget other = RenderTarget.picture(gl, "o", PixelFormat.RGBA8, 4, 4)) {
                    other.clear(1, 0, 0);
                    target.clear(0, 1, 0);
                    assertEquals((byte) 255, other.readBytes().get(0));
                    assertEquals(0, target.readBytes().get(0));
                }
            }
            gl.requireNoError("reuse");
        }
    }

    @Test
    void clearingDepthWorksAfterDrawingWithoutDepth() {
        try (GlContext gl = GlContext.offscreen();
                RenderTarget target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 4, 4)) {
            gl.state().set(DrawState.Depth.LESS_OR_EQUAL, DrawState.Blend.OVER, DrawState.Cull.BACK);
            target.clear(0, 0, 0);
            assertEquals(1f, target.readDepth()[5]);
        }
    }

    @Test
    void pixelsGoUpAndComeBack() {
        try (GlContext gl = GlContext.offscreen();
                RenderTarget target = RenderTarget.picture(gl, "t", PixelFormat.RGBA8, 3, 2)) {
            ByteBuffer texels = ByteBuffer.allocateDirect(24);
            for (int i = 0; i < 24; i++) {
                texels.put(i, (byte) (10 * i));
            }
            target.colour().upload(0, texels);
            assertEquals(texels, target.readBytes());
            assertFalse(gl.limits().version().isEmpty());
        }
    }
}
