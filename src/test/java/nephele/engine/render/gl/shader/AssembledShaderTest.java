package nephele.engine.render.gl.shader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

class AssembledShaderTest {
    private static final String FOLDER = "/nephele/engine/render/include/";
    private static final Map<String, String> FILES = Map.of(
            "/main.frag",
            "// main\n#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() { wrong }\n",
            FOLDER + "a.glsl",
            "// a\nfloat a;\n",
            FOLDER + "b.glsl",
            "#include \"a.glsl\"\nfloat b;\n");

    private static AssembledShader assembled(String path, Map<String, String> defines, UnaryOperator<String> read) {
        return new AssembledShader(new ShaderSource(path, defines, read));
    }

    @Test
    void includesComeInTheirPlace() {
        String text = assembled("/main.frag", Map.of(), FILES::get).text();
        assertTrue(text.indexOf("float a;") < text.indexOf("float b;"));
        assertTrue(text.indexOf("float b;") < text.indexOf("void main"));
        assertFalse(text.contains("#include"));
    }

    @Test
    void aCircleOfIncludesIsRefused() {
        GlException e = assertThrows(
                GlException.class, () -> assembled(FOLDER + "c.glsl", Map.of(), path -> "#include \"c.glsl\"\n"));
        assertTrue(e.getMessage().contains("c.glsl"), e.getMessage());
    }

    @Test
    void definesComeFirstInTheOrderOfTheirNames() {
        String text =
                assembled("/main.frag", Map.of("B", "2", "A", "1"), FILES::get).text();
        assertTrue(text.startsWith("#version 410 core\n#define A 1\n#define B 2\n"), text);
    }

    @Test
    void aCompilersPlacesBecomeFilesAndLines() {
        AssembledShader source = assembled("/main.frag", Map.of(), FILES::get);
        assertEquals("main.frag:4(15): error: x", source.withFileNames("0:4(15): error: x"));
        assertEquals("b.glsl:2: error", source.withFileNames("ERROR: 2:2: error"));
        assertEquals("a.glsl:1 : error", source.withFileNames("1(1) : error"));
    }
}
