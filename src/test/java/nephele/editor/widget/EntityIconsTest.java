package nephele.editor.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.editor.panel.model.PaletteEntry;
import nephele.editor.record.Entities;
import org.junit.jupiter.api.Test;

/** Whatever can be placed has a symbol of its own. */
class EntityIconsTest {
    @Test
    void eachKindOfThePaletteHasADrawing() {
        List<PaletteEntry> without = PaletteEntry.all(Entities.LEVEL).stream()
                .filter(entry ->
                        EntityIcons.drawing(entry.section(), entry.kind()).isEmpty())
                .toList();
        assertEquals(List.of(), without);
    }
}
