package nephele.engine.render.gl.shader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlProgram;
import nephele.engine.render.gl.shader.Uniforms.IfRead;
import org.junit.jupiter.api.Test;

/** A record declares the uniforms of a program. */
class UniformsGlTest {
    private static final String VERTEX = "uniform vec3 offset;\nvoid main() { gl_Position = vec4(offset, 1.0); }\n";
    private static final String FRAGMENT = "uniform vec4 lights[3];\nuniform int count;\nout vec4 colour;\n"
            + "void main() { colour = vec4(0.0); for (int i = 0; i < count; i++) { colour += lights[i]; } }\n";

    private record Lights(List<Uniforms.Vector4> lights, Uniforms.Whole count) {}

    private record All(Uniforms.Vector3 offset, Lights group, @IfRead Uniforms.Scalar fade, @IfRead Gone gone) {}

    private record Gone(List<Uniforms.Vector2> places, Uniforms.Matrix4 map) {}

    private record Missing(Uniforms.Vector3 offset, Uniforms.Scalar fade) {}

    private record OtherType(Uniforms.Vector4 offset) {}

    private static <U extends Record> GlProgram<U> program(GlContext gl, String fragment, Class<U> uniforms) {
        return GlProgram.of(gl, source("a.vert", VERTEX), source("a.frag", fragment), uniforms);
    }

    private static ShaderSource source(String name, String text) {
        return new ShaderSource("/" + name, Map.of(), path -> text);
    }

    @Test
    void groupsArraysAndAbsentUniformsAreFound() {
        try (GlContext gl = GlContext.offscreen()) {
            All uniforms = program(gl, FRAGMENT, All.class).uniforms();
            assertEquals(3, uniforms.group().lights().size());
            assertEquals(List.of(), uniforms.gone().places());
            uniforms.offset().set(new Vec3(1, 2, 3));
            uniforms.group().lights().get(2).set(Vec3.ZERO, 1);
            uniforms.group().count().set(3);
            uniforms.fade().set(0.5);
            uniforms.gone().map().set(new float[16]);
            gl.requireNoError("setting uniforms");
        }
    }

    @Test
    void missingUniformsOtherTypesAndUnnamedSamplersAreRefused() {
        String sampling = "uniform sampler2D unnamed;\nout vec4 colour;\n"
                + "void main() { colour = texture(unnamed, vec2(0.5)); }\n";
        try (GlContext gl = GlContext.offscreen()) {
            assertRefused("'fade'", () -> program(gl, FRAGMENT, Missing.class));
            assertRefused("'offset' with another type", () -> program(gl, FRAGMENT, OtherType.class));
            assertRefused("'unnamed'", () -> program(gl, sampling, All.class));
        }
    }

    private static void assertRefused(String words, org.junit.jupiter.api.function.Executable made) {
        GlException e = assertThrows(GlException.class, made);
        assertTrue(e.getMessage().contains(words), e.getMessage());
    }
}
