package nephele.editor.panel;

import java.util.List;
import java.util.Set;
import nephele.editor.document.Document;
import nephele.editor.document.Notes;
import nephele.editor.document.Selection;
import nephele.editor.panel.model.PanelText;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Limits;
import nephele.engine.level.TextKind;

/** The steps that the outliner makes. */
record OutlinerEdits(EditorSession session) {
    private Document document() {
        return session.document();
    }

    private static String named(List<EntityRef> refs) {
        return refs.size() == 1 ? refs.get(0).shortName() : String.valueOf(refs.size());
    }

    void toggleHidden(List<EntityRef> refs) {
        if (!refs.isEmpty()) {
            document().edit(PanelText.SHOW_OR_HIDE.with(named(refs)), level -> Notes.hiddenToggled(level, refs));
        }
    }

    void toggleLocked(List<EntityRef> refs) {
        if (!refs.isEmpty()) {
            document().edit(PanelText.LOCK_OR_UNLOCK.with(named(refs)), level -> Notes.lockedToggled(level, refs));
        }
    }

    void rename(EntityRef ref, String id) {
        EntityRef renamed = new EntityRef(ref.section(), id);
        if (id.isEmpty() || id.equals(ref.id())) {
            return;
        }
        if (id.length() > TextKind.ID.longest()) {
            session.status(Limits.length(id.substring(0, 8) + "…", TextKind.ID));
            return;
        }
        if (document().entities().find(document().level(), renamed).isPresent()) {
            session.status(PanelText.ID_TAKEN.with(id));
            return;
        }
        document().edit(PanelText.RENAME_TO.with(id), null, now -> now.renamed(ref, id));
    }

    /** Selects what refers to an entity, and says how much it is. */
    void selectUsages(EntityRef ref) {
        Set<EntityRef> usages = document().entities().usages(document().level(), ref);
        if (usages.isEmpty()) {
            session.status(PanelText.NO_USAGES.with(ref.shortName()));
        } else {
            document().select(Selection.of(usages));
            session.status(PanelText.USAGES.with(usages.size(), ref.shortName()));
        }
    }
}
