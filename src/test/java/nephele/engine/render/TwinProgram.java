package nephele.engine.render;

import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;

/** Runs one include's function on many inputs, a pixel each, into 32-bit floats. */
public final class TwinProgram {
    private static final String FOLDER = "/nephele/engine/render/twin/";

    private TwinProgram() {}

    /**
     * Runs a shader.
     *
     * @param inputs four floats to a texel, the same number of texels for each of {@code count} pixels
     * @return three floats for each pixel
     */
    public static float[] run(String shader, float[] inputs, int count, Consumer<Uniforms> setUp) {
        try (GlContext gl = GlContext.offscreen()) {
            return run(gl, shader, inputs, count, setUp);
        }
    }

    /** Runs a shader in a context that is current. */
    public static float[] run(GlContext gl, String shader, float[] inputs, int count, Consumer<Uniforms> setUp) {
        try (RenderTarget target = RenderTarget.picture(gl, "twin", PixelFormat.RGBA32F, count, 1);
                BufferTexture texels = BufferTexture.ofFloats(gl, "inputs", inputs);
                FullScreenTriangle triangle = new FullScreenTriangle(gl, "twin")) {
            var program = new GlProgram<>(
                    gl,
                    ShaderSource.load(FOLDER + "twin.vert", Map.of()),
                    ShaderSource.load(FOLDER + shader, Map.of()),
                    uniforms -> {
                        uniforms.sampler("inputs", TextureUnit.COLOURS);
                        setUp.accept(uniforms);
                        return uniforms;
                    });
            target.clear(-1, -1, -1);
            gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
            texels.bind(TextureUnit.COLOURS);
            program.use();
            triangle.draw();
            gl.requireNoError(shader);
            return target.readFloats();
        }
    }
}
