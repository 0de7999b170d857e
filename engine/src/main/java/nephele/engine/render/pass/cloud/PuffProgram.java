package nephele.engine.render.pass.cloud;

import nephele.engine.cloud.light.BallLight;
import nephele.engine.cloud.light.BeamLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.render.frame.Defines;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.ShaderSource;
import nephele.engine.render.gl.shader.Uniforms;

/** A program that draws the balls of a cloud as quads, with its numbers. */
public final class PuffProgram {
    private final GlProgram<Places> program;
    private final BallLight light;

    /**
     * @param stepping {@code null} for light along the beam, which needs no depths beside a ball
     * @param beamLobes {@code null} for the tail
     */
    private record Places(
            PixelUniforms pixels,
            CellUniforms cells,
            Uniforms.Vector4 stepping,
            Uniforms.Scalar margin,
            Uniforms.Vector4 beamLobes) {}

    /**
     * @param shaders path of both shaders without the ending
     * @param choices further definitions
     */
    public PuffProgram(CloudContext context, CloudPixels pixels, String shaders, BallLight light, Defines choices) {
        this.light = light;
        boolean isBeam = light != BallLight.TAIL;
        var defines = choices.with("QUADS")
                .withIf(isBeam, "BEAM")
                .with("MOST_BOXES", DensityUniforms.MOST_BOXES)
                .values();
        program = new GlProgram<>(
                context.load().gl(),
                ShaderSource.load(shaders + ".vert", defines),
                ShaderSource.load(shaders + ".frag", defines),
                uniforms -> {
                    return new Places(
                            PixelUniforms.of(uniforms, context, pixels),
                            isBeam
                                    ? CellUniforms.ofBeam(uniforms)
                                    : CellUniforms.of(uniforms, CloudScattering.TWO_STREAM),
                            isBeam ? null : uniforms.vector4("stepping"),
                            uniforms.scalar("margin"),
                            isBeam ? uniforms.vector4("beamLobes") : null);
                });
    }

    /** Uses it for a cloud. */
    void use(CloudCanvas canvas, PlacedCloud placed, LitCloud lit) {
        program.use();
        Places places = program.uniforms();
        canvas.put(places.pixels, placed);
        lit.put(places.cells, canvas.view(), canvas.focus());
        places.margin.set((float) canvas.margin());
        if (places.beamLobes == null) {
            places.stepping.set(1, 0.5f, (float) canvas.view().eyeY(), (float) lit.depthAround(canvas.view()));
        } else {
            put(places.beamLobes, light.beam(placed.source().physics().optics()));
        }
    }

    private static void put(Uniforms.Vector4 lobes, BeamLight beam) {
        CloudOptics optics = beam.optics();
        lobes.set((float) optics.g(), (float) optics.backG(), (float) optics.backShare(), (float) beam.fading());
    }
}
