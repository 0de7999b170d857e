package nephele.editor.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The index that an edit gives is where the list after it has the entry. */
@Execution(ExecutionMode.CONCURRENT)
class ListEditTest {
    private static List<ListEdit> all(int size) {
        List<ListEdit> edits = new ArrayList<>();
        for (int from = 0; from < size; from++) {
            edits.add(ListEdit.removed(from));
            edits.add(ListEdit.inserted(from));
            for (int to = 0; to < size; to++) {
                edits.add(ListEdit.moved(from, to));
            }
        }
        return edits;
    }

    @Test
    void entriesAreWhereTheirIndicesSay() {
        for (int size = 1; size < 7; size++) {
            List<Integer> list = IntStream.range(0, size).boxed().toList();
            for (ListEdit edit : all(size)) {
                List<?> after = edit.on(list);
                List<Integer> left = new ArrayList<>();
                for (int i = 0; i < size; i++) {
                    if (edit.after(i) != ListEdit.NONE) {
                        assertEquals(i, after.get(edit.after(i)), edit + " of " + size);
                        left.add(edit.after(i));
                    }
                }
                int fresh = edit.from() == ListEdit.NONE ? 1 : 0;
                assertEquals(after.size() - fresh, left.stream().distinct().count(), edit + " of " + size);
            }
        }
    }

    @Test
    void aMoveBackUndoesAMove() {
        List<String> list = List.of("a", "b", "c", "d");
        assertEquals(List.of("b", "c", "a", "d"), ListEdit.moved(0, 2).on(list));
        assertEquals(list, ListEdit.moved(2, 0).on(ListEdit.moved(0, 2).on(list)));
        assertEquals(List.of("a", "b", "b", "c", "d"), ListEdit.inserted(1).on(list));
        assertSame(list, ListEdit.removed(4).on(list));
    }
}
