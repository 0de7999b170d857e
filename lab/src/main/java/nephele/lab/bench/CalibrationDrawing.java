package nephele.lab.bench;

import java.nio.ByteBuffer;
import java.util.Map;
import nephele.engine.render.gl.DrawState.Blend;
import nephele.engine.render.gl.DrawState.Cull;
import nephele.engine.render.gl.DrawState.Depth;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.render.gl.shader.Uniforms;
import org.lwjgl.system.MemoryUtil;

/**
 * A fixed workload that measures the speed of a machine: a clear and one full-screen texture, read bilinearly. It takes
 * {@value #USUAL_MS} ms of CPU on the machine on which the performance limits were set.
 */
public final class CalibrationDrawing implements Drawing {
    public static final double USUAL_MS = 5.8;

    private static final int TEXELS = 512;
    private static final String FOLDER = "/nephele/lab/bench/";

    private final GlContext gl;
    private final RenderTarget picture;
    private final Texture checks;
    private final FullScreenTriangle triangle;
    private final GlProgram<Uniforms> program;

    public CalibrationDrawing(GlContext gl, int width, int height) {
        this.gl = gl;
        picture = RenderTarget.picture(gl, "picture", PixelFormat.RGBA8, width, height);
        var extent = Texture.Extent.flat(TEXELS, TEXELS);
        checks = new Texture(gl, "checks", Texture.Shape.FLAT, PixelFormat.RGBA8, extent, Sampling.LINEAR_CLAMP);
        upload();
        triangle = new FullScreenTriangle(gl, "calibration");
        program = new GlProgram<>(
                gl,
                ShaderSource.load(FOLDER + "calibrate.vert", Map.of()),
                ShaderSource.load(FOLDER + "calibrate.frag", Map.of()),
                uniforms -> {
                    uniforms.sampler("checks", TextureUnit.COLOURS);
                    return uniforms;
                });
    }

    private void upload() {
        ByteBuffer texels = MemoryUtil.memAlloc(4 * TEXELS * TEXELS);
        for (int i = 0; i < TEXELS * TEXELS; i++) {
            boolean light = ((i ^ i / TEXELS) & 8) == 0;
            texels.putInt(light ? 0xffc0c0c0 : 0xff404040);
        }
        checks.upload(0, texels.flip());
        MemoryUtil.memFree(texels);
    }

    @Override
    public int roundLength() {
        return 1;
    }

    @Override
    public void draw(int frame) {
        gl.state().resetCounts();
        picture.clear(0, 0, 0);
        gl.state().set(Depth.OFF, Blend.REPLACE, Cull.NONE);
        checks.bind(TextureUnit.COLOURS);
        program.use();
        triangle.draw();
    }

    @Override
    public void close() {
        triangle.close();
        checks.close();
        picture.close();
    }
}
