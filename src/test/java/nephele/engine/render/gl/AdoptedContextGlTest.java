package nephele.engine.render.gl;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.lwjgl.opengl.GL41C.*;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.lwjgl.opengl.GL;

/** Frames are correct in a context that another toolkit made and has used. */
class AdoptedContextGlTest {
    private static final int SIDE = 48;

    private static Level level() {
        return new TestLevel()
                .castingSun(new Vec3(0.3, 1, 0.2), 3)
                .ambient(0.2)
                .material("red", new Vec3(0.7, 0.2, 0.1))
                .box("red", new Vec3(0, -1, 0), new Vec3(9, 1, 9))
                .box("red", new Vec3(0, 0, -2), new Vec3(1, 1, 1))
                .cube("red", new Vec3(1, 0, -1), 0.5)
                .portal("a", "b", new Vec3(-0.5, 0, -1.49), new Vec3(0, 0, 1), 0.4, 0.8)
                .portal("b", "a", new Vec3(0, -0.5, 1), new Vec3(0, 1, 0), 0.4, 0.8)
                .level();
    }

    private static byte[] frame(GlContext gl, Renderer renderer, RenderTarget picture) {
        Vec3 eye = new Vec3(0.3, 1.5, 3);
        var projection = new Projection(Math.PI / 2, 1, 0.05, 100);
        renderer.draw(View.lookAt(eye, new Vec3(0, -0.2, -1), new Vec3(0, 1, 0), projection), picture);
        gl.requireNoError("frame");
        byte[] bytes = new byte[4 * SIDE * SIDE];
        picture.readBytes().get(bytes);
        return bytes;
    }

    static byte[] expected() {
        try (GlContext gl = GlContext.offscreen()) {
            return frame(gl);
        }
    }

    /** Returns a frame of the level, drawn in a context of any kind. */
    static byte[] frame(GlContext gl) {
        try (RenderTarget picture = RenderTarget.picture(gl, "expected", PixelFormat.RGBA8, SIDE, SIDE);
                Renderer renderer = LevelRenderer.load(gl, level(), TestAssets.NONE, settings())) {
            return frame(gl, renderer, picture);
        }
    }

    private static RenderSettings settings() {
        return RenderSettings.of(Output.DIRECT, Quality.MEDIUM);
    }

    /** Leaves every state different from what a frame needs. */
    private static void foreignFrame() {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glBindVertexArray(0);
        glUseProgram(0);
        for (int unit = 0; unit < TextureUnit.COUNT; unit++) {
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, 0);
            glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
            glBindTexture(GL_TEXTURE_BUFFER, 0);
        }
        glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        glEnable(GL_SCISSOR_TEST);
        glScissor(1, 2, 3, 4);
        glViewport(5, 6, 7, 8);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ZERO, GL_ONE);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT_AND_BACK);
        glFrontFace(GL_CW);
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_NEVER, 1, 0xff);
        glDisable(GL_DEPTH_TEST);
        glDepthFunc(GL_NEVER);
        glDepthMask(false);
        glDepthRange(0.2, 0.3);
        glColorMask(false, true, false, true);
        glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(9, 9);
        glEnable(GL_CLIP_DISTANCE0);
        glEnable(GL_CLIP_DISTANCE0 + 2);
        glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
        glClearDepth(0.1);
        glClearStencil(3);
        glStencilMask(0xf0);
    }

    @Test
    void whatAnotherToolkitLeavesDoesNotShow() {
        byte[] expected = expected();
        OffscreenContext foreign = OffscreenContext.makeCurrent();
        GL.createCapabilities();
        foreignFrame();
        try (GlContext gl = GlContext.ofCurrent();
                RenderTarget picture = RenderTarget.picture(gl, "adopted", PixelFormat.RGBA8, SIDE, SIDE);
                Renderer renderer = LevelRenderer.load(gl, level(), TestAssets.NONE, settings())) {
            assertArrayEquals(expected, frame(gl, renderer, picture));
        }
        glUseProgram(0);
        assertEquals(GL_NO_ERROR, glGetError(), "the context goes on to be its maker's");
        GL.setCapabilities(null);
        foreign.destroy();
    }
}
