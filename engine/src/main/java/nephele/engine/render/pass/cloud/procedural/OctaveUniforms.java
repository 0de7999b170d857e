package nephele.engine.render.pass.cloud.procedural;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.cloud.octave.NoiseOctave;
import nephele.engine.cloud.octave.OctaveSheet;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.shader.Uniforms;

/** The uniforms of {@code cloud-octaves.glsl}. */
public record OctaveUniforms(
        List<Uniforms.Vector4> scale,
        List<Uniforms.Vector4> place,
        List<Uniforms.WholeVector4> cell,
        Uniforms.Vector3 excess) {
    /** Octaves that a sheet has at most. */
    private static final int MOST_OCTAVES = 5;

    public static OctaveUniforms of(Uniforms uniforms) {
        return new OctaveUniforms(
                named("octaveScale").map(uniforms::vector4).toList(),
                named("octavePlace").map(uniforms::vector4).toList(),
                named("octaveCell").map(uniforms::wholeVector4).toList(),
                uniforms.vector3("excess"));
    }

    private static Stream<String> named(String name) {
        return IntStream.range(0, MOST_OCTAVES).mapToObj(i -> name + "[" + i + "]");
    }

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
            scale.get(i)
                    .set(
                            (float) (octave.cosine() * cells),
                            (float) (octave.sine() * cells),
                            (float) octave.weight(),
                            (float) variance);
            double u = octave.u(eye.x(), eye.z());
            double v = octave.v(eye.x(), eye.z());
            place.get(i).set((float) (u - Math.floor(u)), (float) (v - Math.floor(v)), (float) fading, (float) coming);
            int generation = octave.generation(seconds);
            cell.get(i)
                    .set(NoiseOctave.cell(u), NoiseOctave.cell(v), octave.key(generation), octave.key(generation + 1));
        }
        excess.set((float) sheet.threshold(), (float) (1 / sheet.greatest()), octaves.size());
    }
}
