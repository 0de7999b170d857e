package nephele.scenes.fixed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.render.TwinProgram;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.scenes.xml.XmlLight;
import nephele.scenes.xml.XmlModel.Colours;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The light model in the shader equals its Java twin: float on one side, double on the other. */
class FixedLightGlTest {
    private static final int COUNT = 4096;
    private static final int FLOATS = 48;

    private final SplittableRandom random = new SplittableRandom(7);

    /** The input of one pixel. */
    private record Case(Colours colours, List<XmlLight> lights, Vec3 point, Vec3 normal) {}

    @ParameterizedTest
    @EnumSource
    void shaderEqualsTwinInEachTerm(LightTerm term) {
        shaderEqualsTwin(EnumSet.of(term));
    }

    @Test
    void shaderEqualsTwinInAllTerms() {
        shaderEqualsTwin(EnumSet.allOf(LightTerm.class));
    }

    private void shaderEqualsTwin(Set<LightTerm> terms) {
        Case[] cases = new Case[COUNT];
        float[] in = new float[FLOATS * COUNT];
        for (int i = 0; i < COUNT; i++) {
            cases[i] = randomCase(i);
            pack(cases[i], i, in);
        }
        Vec3 viewer = unit();
        var look = SceneAppearance.USUAL.with(terms);
        float[] gpu = TwinProgram.run("fixed-light.frag", in, COUNT, uniforms -> {
            uniforms.sampler("fixedLights", TextureUnit.COLOURS);
            uniforms.vector3("towardsViewer").set((float) viewer.x(), (float) viewer.y(), (float) viewer.z());
            uniforms.vector4("lightTerms")
                    .set(
                            look.term(LightTerm.AMBIENT),
                            look.term(LightTerm.DIFFUSE),
                            look.term(LightTerm.SPECULAR),
                            look.term(LightTerm.EMISSIVE));
        });
        for (int i = 0; i < COUNT; i++) {
            Case each = cases[i];
            Vector3d expected = new FixedLight(viewer.toVector(), each.lights, terms)
                    .lit(each.colours, each.point.toVector(), each.normal.toVector());
            for (int channel = 0; channel < 3; channel++) {
                assertEquals(expected.get(channel), gpu[3 * i + channel], 1e-4, "case " + i + ": " + each);
            }
        }
    }

    /**
     * Returns a random case, including shininess and exponent 0, lights in the point itself and behind it, all-round
     * and narrow spots.
     */
    private Case randomCase(int i) {
        double shininess = i % 4 == 0 ? 0 : i % 4 == 1 ? 128 : 128 * random.nextDouble();
        Colours colours = new Colours(colour(1), colour(0.3), colour(1), colour(0.2), shininess);
        Vec3 point = new Vec3(coordinate(), coordinate(), coordinate());
        XmlLight odd = i % 9 == 0 ? new XmlLight.Point(point) : new XmlLight.Directional(unit());
        return new Case(colours, List.of(light(i), odd), point, unit());
    }

    private XmlLight light(int i) {
        Vec3 position = new Vec3(coordinate(), coordinate(), coordinate());
        if (i % 3 == 0) {
            return new XmlLight.Point(position);
        }
        double cutoff = i % 5 == 0 ? 180 : 90 * random.nextDouble();
        double exponent = i % 7 == 0 ? 0 : 20 * random.nextDouble();
        return new XmlLight.Spot(position, unit(), cutoff, exponent);
    }

    private double coordinate() {
        // Rounded to float, so that both sides have the same value.
        return (float) (random.nextDouble() * 8 - 4);
    }

    private Vec3 colour(double most) {
        return new Vec3(most * random.nextDouble(), most * random.nextDouble(), most * random.nextDouble());
    }

    private Vec3 unit() {
        Vector3d v;
        do {
            v = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        } while (v.length() < 0.1);
        return Vec3.of(v.normalize());
    }

    private static void pack(Case each, int i, float[] in) {
        var lights = new LightTable(2);
        lights.put(0, each.lights.get(0), new Matrix4d(), 4 * i + 1);
        lights.put(1, each.lights.get(1), new Matrix4d(), -1);
        int at = FLOATS * i;
        System.arraycopy(lights.packed(), 0, in, at, 24);
        put(in, at + 24, each.colours.ambient(), 0);
        put(in, at + 28, each.colours.diffuse(), 0);
        put(in, at + 32, each.colours.specular(), each.colours.shininess());
        put(in, at + 36, each.colours.emissive(), 0);
        put(in, at + 40, each.point, 0);
        put(in, at + 44, each.normal, 0);
    }

    private static void put(float[] in, int at, Vec3 v, double last) {
        in[at] = (float) v.x();
        in[at + 1] = (float) v.y();
        in[at + 2] = (float) v.z();
        in[at + 3] = (float) last;
    }
}
