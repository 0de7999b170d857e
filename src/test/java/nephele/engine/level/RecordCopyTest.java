package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class RecordCopyTest {
    private record Rod(String name, double metres, List<String> marks) {
        Rod {
            if (metres < 0) {
                throw new IllegalArgumentException("a rod is no shorter than nothing");
            }
        }
    }

    private static final Rod ROD = new Rod("yard", 0.9, List.of("a"));

    @Test
    void theNamedComponentsAreOther() {
        assertEquals(new Rod("fathom", 2, List.of("a")), RecordCopy.with(ROD, "name", "fathom", "metres", 2));
        assertEquals(new Rod("yard", 0.9, null), RecordCopy.with(ROD, "marks", null));
        assertEquals(ROD, RecordCopy.with(ROD));
    }

    @Test
    void anUnknownNameAndAValueOfAnotherTypeAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> RecordCopy.with(ROD, "feet", 3));
        assertThrows(IllegalArgumentException.class, () -> RecordCopy.with(ROD, "metres", "long"));
    }

    @Test
    void theRecordRefusesWhatItsConstructorDoes() {
        var refused = assertThrows(IllegalArgumentException.class, () -> RecordCopy.with(ROD, "metres", -1));
        assertEquals("a rod is no shorter than nothing", refused.getMessage());
    }
}
