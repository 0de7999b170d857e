package nephele.engine.level;

import java.util.List;

/**
 * How an author has arranged a level in the editor; nothing that is drawn or simulated depends on it. Entities are named
 * {@code section/id}, such as {@code solids/north-wall}.
 *
 * @param hidden entities that the editor does not show
 * @param locked entities that the editor does not select in a view
 * @param ignoredProblems problems that the author has decided to keep, as the problems panel names them
 */
public record EditorNotes(
        @Written(most = 10_000) List<Group> groups,
        @Written(most = 100_000) List<String> hidden,
        @Written(most = 100_000) List<String> locked,
        @Written(most = 10_000) List<String> ignoredProblems) {
    public static final EditorNotes NONE = new EditorNotes(List.of(), List.of(), List.of(), List.of());

    /** Entities that are selected together. */
    public record Group(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, most = 100_000) List<String> members) {}
}
