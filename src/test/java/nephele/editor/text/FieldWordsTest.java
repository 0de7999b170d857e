package nephele.editor.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.TreeSet;
import nephele.editor.panel.model.BeaconLevel;
import nephele.editor.panel.model.PaletteEntry;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class FieldWordsTest {
    private final Set<RecordKind> kinds = new LinkedHashSet<>();
    private final Set<String> names = new TreeSet<>();

    private void walk(Class<?> type) {
        if (kinds.add(RecordKind.of(type))) {
            for (RecordField field : RecordKind.of(type).fields()) {
                names.add(field.name());
                field.recordClasses().forEach(this::walk);
            }
        }
    }

    @Test
    void everyComponentOfALevelHasWordsInEachLanguage() {
        walk(Level.class);
        assertTrue(names.size() > 80, "the walk reaches the records");
        names.removeIf(name -> FieldWords.known(name).isPresent());
        assertEquals(Set.of(), names);
        for (RecordKind kind : kinds) {
            for (RecordField field : kind.fields()) {
                for (Language language : Language.values()) {
                    String words = FieldWords.of(field).in(language);
                    assertFalse(words.isBlank(), field.name());
                    assertTrue(Character.isUpperCase(words.charAt(0)), words);
                }
            }
        }
    }

    @Test
    void everyKindInThePaletteHasWords() {
        for (PaletteEntry entry : PaletteEntry.all(nephele.editor.record.Entities.LEVEL)) {
            assertTrue(EntityWords.knownKind(entry.kind()).isPresent(), entry.kind());
        }
    }

    @Test
    void aComponentAddedLaterIsNamedByItsIdentifier() {
        RecordField period =
                RecordKind.of(BeaconLevel.Beacon.class).field("periodSeconds").orElseThrow();
        assertEquals("Period", FieldWords.of(period).english());
        assertEquals("Period", FieldWords.of(period).brazilian());
        assertEquals("Beacon", EntityWords.ofKind("beacon").english());
    }
}
