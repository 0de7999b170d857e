package nephele.editor.panel.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Optional;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Environment;
import nephele.engine.level.Exit;
import nephele.engine.level.Exposure;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A text is the value of a field only if a file could hold it. */
@Execution(ExecutionMode.CONCURRENT)
class FieldTypeTest {
    private static final Map<String, Class<?>> OWNERS = Map.of(
            "radiusMetres", Exit.class,
            "feet", Exit.class,
            "id", Exit.class,
            "portalable", Solid.Box.class,
            "sides", Solid.Prism.class,
            "toneCurve", Environment.class,
            "exposureStops", Environment.class,
            "clouds", Environment.class);

    private static Optional<Object> read(String field, String text) {
        return FieldType.of(RecordKind.of(OWNERS.get(field)).field(field).orElseThrow())
                .read(text);
    }

    @ParameterizedTest
    @CsvSource({
        "radiusMetres, 1.5, 1.5",
        "radiusMetres, 3/2, 1.5",
        "sides, 6, 6",
        "portalable, true, true",
        "toneCurve, clip, CLIP",
        "exposureStops, auto, auto",
        "exposureStops, -2*3/4, -1.5",
        "id, door, door"
    })
    void aPermittedTextIsItsValue(String field, String text, String value) {
        assertEquals(value, read(field, text).orElseThrow().toString());
    }

    @ParameterizedTest
    @CsvSource({
        "radiusMetres, wide",
        "radiusMetres, 0",
        "radiusMetres, NaN",
        "sides, 6.5",
        "sides, 2",
        "sides, 4294967302",
        "portalable, yes",
        "toneCurve, sharp",
        "exposureStops, Auto",
        "exposureStops, 33",
        "exposureStops, x",
        "id, ''",
        "clouds, c",
        "feet, '1, 2'",
        "feet, '1, 2, 3, 4'",
        "feet, '1, x, 3'",
        "feet, '1, 2, 1e9'"
    })
    void anyOtherTextIsNone(String field, String text) {
        assertEquals(Optional.empty(), read(field, text));
    }

    @ParameterizedTest
    @CsvSource({"'1,2,3'", "' 1, 4/2 , 3'"})
    void aVectorIsThreeNumbers(String text) {
        assertEquals(Optional.of(new Vec3(1, 2, 3)), read("feet", text));
    }

    /** A drag on the title changes stops; there is nothing to change in the word. */
    @Test
    void aShiftChangesNumbersOnly() {
        FieldType exposure = FieldType.of(
                RecordKind.of(Environment.class).field("exposureStops").orElseThrow());
        assertEquals(Exposure.ofStops(1.25), exposure.shifted(Exposure.ofStops(1), 0.25));
        assertEquals(Exposure.AUTO, exposure.shifted(Exposure.AUTO, 0.25));
        FieldType sides =
                FieldType.of(RecordKind.of(Solid.Prism.class).field("sides").orElseThrow());
        assertEquals(8, sides.shifted(6, 2.1));
    }
}
