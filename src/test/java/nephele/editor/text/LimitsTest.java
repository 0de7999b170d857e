package nephele.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Camera;
import nephele.engine.level.Language;
import nephele.engine.level.Sky;
import nephele.engine.level.TexturePlacement;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** The words for a value that no file can hold have its range, whatever its shape. */
class LimitsTest {
    private static Words problem(Class<?> record, String name, Object value) {
        RecordField field = RecordKind.of(record).field(name).orElseThrow();
        return Limits.problem(field, value).orElse(Words.NONE);
    }

    @Test
    void aRangeOfTwoPartsIsTold() {
        Words day = problem(Sky.Atmosphere.class, "dayLengthSeconds", Double.MIN_VALUE);
        assertEquals("Length of a day must be 0 or 1 … 1000000000 s", day.english());
        assertEquals("Duração do dia deve ser 0 ou 1 … 1000000000 s", day.in(Language.PT_BR));
        Words scale = problem(TexturePlacement.class, "scaleU", 0.0);
        assertTrue(scale.english().contains("-10000 … -0.001 or 0.001 … 10000"), scale.english());
    }

    @Test
    void aDirectionNeedsALength() {
        assertEquals(
                "Up has no length: give a direction that points somewhere",
                problem(Camera.class, "up", new Vec3(0, 1e-300, 0)).english());
        assertEquals(Words.NONE, problem(Camera.class, "up", new Vec3(0, 0, -1e-3)));
    }

    @Test
    void theValueOfAnAbsentKeyIsNoFault() {
        assertEquals(Words.NONE, problem(Camera.class, "verticalFovDegrees", 0.0));
        assertEquals(
                "Vertical field of view must be from 1 to 170 °",
                problem(Camera.class, "verticalFovDegrees", 0.5).english());
    }
}
