package nephele.workshop.prove.editor;

import javax.swing.JComponent;

/** Something of the editor to take a picture of. */
record EditorScene(String name, Making making) {
    /** Prepares the editor. */
    @FunctionalInterface
    interface Making {
        /** Returns the part to show by itself; {@code null} for the whole editor. */
        JComponent show(PicturedEditor editor) throws Exception;
    }

    /** Prepares the whole editor. */
    @FunctionalInterface
    interface Preparation {
        void prepare(PicturedEditor editor) throws Exception;
    }

    static EditorScene whole(String name, Preparation preparation) {
        return new EditorScene(name, editor -> {
            editor.escape();
            preparation.prepare(editor);
            return null;
        });
    }
}
