package nephele.editor.tool;

import java.util.function.Consumer;
import java.util.function.Supplier;
import nephele.editor.document.Document;
import nephele.editor.document.Snapshot;
import nephele.editor.pick.Grid;
import nephele.editor.pick.LevelShapes;
import nephele.editor.pick.Picker;
import nephele.editor.text.Words;
import nephele.engine.level.Level;

/** What a tool works on: the document, its shapes, the grid and the options. */
public final class ToolContext {
    private final Document document;
    private final ToolOptions options;
    private final Supplier<Grid> grid;
    private final Consumer<Words> status;
    private LevelShapes shapes;
    private Level shapesOf;

    /** @param status receives messages for the status bar, such as why an edit is refused */
    public ToolContext(Document document, ToolOptions options, Supplier<Grid> grid, Consumer<Words> status) {
        this.document = document;
        this.options = options;
        this.grid = grid;
        this.status = status;
        shapes = LevelShapes.of(document.level());
        shapesOf = document.level();
    }

    public Document document() {
        return document;
    }

    public ToolOptions options() {
        return options;
    }

    public Grid grid() {
        return grid.get();
    }

    public void status(Words words) {
        status.accept(words);
    }

    /** Returns the shapes of what is shown, a drag in progress included. */
    public LevelShapes shapes() {
        Level now = document.level();
        if (now != shapesOf) {
            shapes = shapes.edited(now);
            shapesOf = now;
        }
        return shapes;
    }

    /** Returns a picker of what is shown. */
    public Picker picker() {
        Snapshot now = document.now();
        return new Picker(now.level(), shapes(), document.entities());
    }
}
