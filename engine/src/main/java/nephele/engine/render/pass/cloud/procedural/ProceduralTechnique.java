package nephele.engine.render.pass.cloud.procedural;

import java.util.List;
import nephele.engine.cloud.drawn.CloudInterval;
import nephele.engine.cloud.octave.NoiseOctave;
import nephele.engine.cloud.octave.OctaveSheet;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Quality.CloudScattering;
import nephele.engine.render.gl.FullScreenTriangle;
import nephele.engine.render.gl.shader.Uniforms.Vector2;
import nephele.engine.render.gl.shader.Uniforms.Vector3;
import nephele.engine.render.gl.shader.Uniforms.Vector4;
import nephele.engine.render.gl.shader.Uniforms.WholeVector4;
import nephele.engine.render.pass.cloud.CloudCanvas;
import nephele.engine.render.pass.cloud.CloudContext;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPrograms;
import nephele.engine.render.pass.cloud.LitCloud;
import nephele.engine.render.pass.cloud.PlacedCloud;

/** Draws a cloud as a sheet whose optical depth is computed from octaves of noise in the shader. */
public final class ProceduralTechnique implements CloudDrawing {
    public static final Technique REGISTERED =
            new Technique(CloudTechnique.PROCEDURAL, cloud -> true, ProceduralTechnique::new);

    /** Octaves that a sheet has at most. */
    private static final int MOST_OCTAVES = 5;

    private final PlacedCloud placed;
    private final LitCloud lit;
    private final CloudPrograms<SheetUniforms> programs;
    private final FullScreenTriangle triangle;

    private record SheetUniforms(CloudPrograms.Shared cloud, Vector2 sheet, Octaves octaves) {}

    /** The uniforms of {@code cloud-octaves.glsl}. */
    public record Octaves(
            List<Vector4> octaveScale, List<Vector4> octavePlace, List<WholeVector4> octaveCell, Vector3 excess) {
        /**
         * Sets the octaves at a time.
         *
         * @param eye in the space that drifts with the cloud
         */
        public void put(OctaveSheet sheet, Vec3 eye, double seconds) {
            List<NoiseOctave> octaves = sheet.octaves();
            for (int i = 0; i < octaves.size(); i++) {
                NoiseOctave octave = octaves.get(i);
                double cells = 1 / octave.cellMetres();
                double fading = octave.fading(seconds);
                double coming = octave.coming(seconds);
                double variance = sheet.variances().get(i) * (fading * fading + coming * coming);
                octaveScale.get(i).set(octave.cosine() * cells, octave.sine() * cells, octave.weight(), variance);
                double u = octave.u(eye.x(), eye.z());
                double v = octave.v(eye.x(), eye.z());
                octavePlace.get(i).set(u - Math.floor(u), v - Math.floor(v), fading, coming);
                int generation = octave.generation(seconds);
                octaveCell
                        .get(i)
                        .set(
                                NoiseOctave.cell(u),
                                NoiseOctave.cell(v),
                                octave.key(generation),
                                octave.key(generation + 1));
            }
            excess.set(sheet.threshold(), 1 / sheet.greatest(), octaves.size());
        }
    }

    private ProceduralTechnique(CloudContext context, PlacedCloud placed) {
        this.placed = placed;
        lit = new LitCloud(context.load(), placed);
        triangle = context.load().own(new FullScreenTriangle(context.load().gl(), "procedural"));
        boolean isOctaves = context.load().quality().cloudScattering() == CloudScattering.OCTAVES;
        boolean isSmooth = context.load().quality().proceduralNoise().isSmooth();
        programs = new CloudPrograms<>(
                context,
                "cloud.vert",
                "procedural/procedural.frag",
                defines -> lit.define(defines).withIf(isOctaves, "OCTAVES").withIf(isSmooth, "SMOOTH"),
                SheetUniforms.class);
    }

    @Override
    public void follow(Environment environment, CloudInterval now) {
        lit.follow(environment, now);
    }

    @Override
    public void draw(CloudCanvas canvas) {
        SheetUniforms uniforms = programs.use(canvas.pixels());
        canvas.put(uniforms.cloud, placed);
        lit.put(uniforms.cloud, canvas.view(), canvas.focus());
        uniforms.sheet.set(canvas.view().eyeY(), lit.longestPathMetres());
        uniforms.octaves.put(placed.source().sheet(), canvas.view().eye().minus(placed.drift()), placed.seconds());
        triangle.draw();
    }
}
