package nephele.editor.proving;

import nephele.editor.document.BackgroundReading;
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Language;
import nephele.engine.level.Level;

/** The open level and the viewport in which its proofs are shown. */
public interface ProvingSubject {
    Level level();

    AssetSource assets();

    /** Returns what runs the reading of files. */
    BackgroundReading background();

    Selection selection();

    /** Returns false during a drag. */
    boolean isSettled();

    PaneLayout panes();

    void panes(PaneLayout panes);

    /** Returns the size of all panes together. */
    PaneSize viewport();

    Language language();

    /** Shows a message in the status line. */
    void status(Words words);

    /** Draws the viewport again, as its marks have changed. */
    void redraw();
}
