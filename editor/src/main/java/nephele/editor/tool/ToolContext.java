package nephele.editor.tool;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import nephele.editor.document.BackgroundReading;
import nephele.editor.document.Document;
import nephele.editor.document.Grid;
import nephele.editor.document.LevelShapes;
import nephele.editor.document.Picker;
import nephele.editor.document.Snapshot;
import nephele.editor.terrain.PaintedMaps;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;

/** The context of a tool: the document, its shapes, the grid and the options. */
public final class ToolContext {
    private final Document document;
    private final ToolOptions options;
    private final Supplier<Grid> grid;
    private final Consumer<Words> status;
    private final Supplier<Optional<AssetSource>> assets;
    private final PaintedMaps maps;
    private final BackgroundReading background = new BackgroundReading();
    private LevelShapes shapes;
    private Level shapesOf;

    /** Creates a context without files: tools then take no notice of models. */
    public ToolContext(Document document, ToolOptions options, Supplier<Grid> grid, Consumer<Words> status) {
        this(document, options, grid, status, Optional::empty, new PaintedMaps(Optional::empty));
    }

    /**
     * Creates a context.
     *
     * @param status receives messages for the status bar, such as why an edit is refused
     * @param assets the files of the level
     * @param maps what strokes on terrains make
     */
    public ToolContext(
            Document document,
            ToolOptions options,
            Supplier<Grid> grid,
            Consumer<Words> status,
            Supplier<Optional<AssetSource>> assets,
            PaintedMaps maps) {
        this.document = document;
        this.options = options;
        this.grid = grid;
        this.status = status;
        this.assets = assets;
        this.maps = maps;
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

    /** Returns the files of the level; empty if they are not known. */
    public Optional<AssetSource> assets() {
        return assets.get();
    }

    /** Returns what runs the reading of files. */
    public BackgroundReading background() {
        return background;
    }

    /** Returns what strokes on terrains make. */
    public PaintedMaps maps() {
        return maps;
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
        return new Picker(now.level(), shapes());
    }
}
