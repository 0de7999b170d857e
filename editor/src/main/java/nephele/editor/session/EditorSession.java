package nephele.editor.session;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import nephele.editor.document.BackgroundReading;
import nephele.editor.document.Document;
import nephele.editor.document.Grid;
import nephele.editor.document.Registration;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout;
import nephele.editor.play.WarmGame;
import nephele.editor.proving.Proving;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.terrain.PaintedMaps;
import nephele.editor.text.Words;
import nephele.editor.tool.Tool;
import nephele.editor.tool.ToolContext;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.ToolOptions;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Language;
import nephele.engine.level.Level;

/**
 * One open level and everything that an action or a window needs of it. It is used by one thread, the event dispatch
 * thread if there is a window.
 */
public final class EditorSession {
    private final Document document;
    private final ToolOptions options = new ToolOptions();
    private final ToolContext context;
    private final Proving proving;
    private final ToolDrag drag;
    private final PaintedMaps maps = new PaintedMaps(() -> file().path());
    private final List<SessionListener> listeners = new ArrayList<>();
    private Filing filing = Filing.ofThisUser();
    private EditorSettings settings;
    private DocumentFile file;
    private AssetSource assets;
    /** The level's files without what strokes have made. */
    private AssetSource files;
    /** The files of the folder that the level was saved from before: undone states still name them. */
    private Optional<AssetSource> former = Optional.empty();

    private Grid grid = new Grid(0.5);
    private PaneLayout panes = PaneLayout.initial();
    private PaneSize viewport = new PaneSize(1280, 720);
    private ToolEntry toolEntry;
    private Tool tool;
    private Words status = Words.NONE;
    private String clipboard = "";
    private Consumer<WarmGame.Request> game = request -> {};

    /** @param assets of the level's file; an untitled level has those of the working folder */
    public EditorSession(DocumentFile file, Level level, AssetSource assets, EditorSettings settings) {
        this.file = file;
        files = assets;
        this.assets = maps.over(assets);
        this.settings = settings;
        document = new Document(level);
        context = new ToolContext(document, options, this::grid, this::status, () -> Optional.of(this.assets), maps);
        proving = new Proving(new ProvedSession(this));
        drag = new ToolDrag(this);
        document.listen((before, after) -> tell(Change.DOCUMENT));
        document.onRefusal(this::status);
        toolEntry = Tools.ALL.get(0);
        tool = toolEntry.make().apply(context);
    }

    /** Registers a listener until the registration is closed. */
    public Registration listen(SessionListener listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /** Tells all listeners of a change. */
    public void tell(Change change) {
        if (change != Change.STATUS && change != Change.SETTINGS) {
            proving.follow();
        }
        List.copyOf(listeners).forEach(listener -> listener.changed(change));
    }

    public Document document() {
        return document;
    }

    /** Returns the drag of the tool in use. */
    public ToolDrag drag() {
        return drag;
    }

    public ToolContext context() {
        return context;
    }

    /** Returns what runs the reading of files. */
    public BackgroundReading background() {
        return context.background();
    }

    /** Returns the proofs about the level. */
    public Proving proving() {
        return proving;
    }

    public ToolOptions options() {
        return options;
    }

    public DocumentFile file() {
        return file;
    }

    public AssetSource assets() {
        return assets;
    }

    /** Returns what strokes on terrains have made. */
    public PaintedMaps maps() {
        return maps;
    }

    /** Replaces the open level by another one with an empty history. */
    public void open(DocumentFile otherFile, Level level, AssetSource otherAssets) {
        drag.cancel();
        tool.cancel();
        maps.discard();
        file = otherFile;
        former = Optional.empty();
        files = otherAssets;
        assets = maps.over(files);
        document.reset(level);
        tell(Change.FILE);
    }

    /** Notes that the level was saved to a file; its files are from then on those beside it. */
    public void saved(DocumentFile savedTo) {
        boolean isElsewhere =
                !savedTo.path().map(Path::getParent).equals(file.path().map(Path::getParent));
        file = savedTo;
        if (isElsewhere) {
            former = Optional.of(files);
            savedTo.path().ifPresent(path -> follow(LevelAssets.beside(path)));
        }
        document.markSaved();
        maps.saved(document.level());
        tell(Change.FILE);
    }

    /** Notes what the file on disk holds now, of which the user knows; the document stays as it is. */
    public void known(DocumentFile outside) {
        file = outside;
        tell(Change.FILE);
    }

    public Filing filing() {
        return filing;
    }

    public void filing(Filing next) {
        filing = next;
    }

    /** Makes the pictures and meshes be read again, since a file has changed. */
    public void reloadAssets(LevelAssets fresh) {
        follow(fresh);
        tell(Change.VIEW);
    }

    private void follow(LevelAssets beside) {
        files = former.map(beside::or).orElse(beside);
        assets = maps.over(files);
    }

    /** Returns true if states of the level may need files of another folder than its own. */
    public boolean hasMoved() {
        return former.isPresent();
    }

    public EditorSettings settings() {
        return settings;
    }

    public void settings(EditorSettings next) {
        settings = next;
        tell(Change.SETTINGS);
    }

    public Language language() {
        return settings.get(EditorSetting.LANGUAGE);
    }

    public Grid grid() {
        return grid;
    }

    public void grid(Grid next) {
        grid = next;
        tell(Change.VIEW);
    }

    public PaneLayout panes() {
        return panes;
    }

    public void panes(UnaryOperator<PaneLayout> change) {
        panes = change.apply(panes);
        tell(Change.VIEW);
    }

    /** Returns the size of the whole viewport in pixels. */
    public PaneSize viewport() {
        return viewport;
    }

    public void viewport(PaneSize size) {
        viewport = size;
    }

    /** Returns the tool in use. */
    public Tool tool() {
        return tool;
    }

    public ToolEntry toolEntry() {
        return toolEntry;
    }

    /** Takes another tool; a drag in progress is cancelled. */
    public void use(ToolEntry entry) {
        drag.cancel();
        tool.cancel();
        document.cancelDrag();
        toolEntry = entry;
        tool = entry.make().apply(context);
        tell(Change.VIEW);
    }

    public Words status() {
        return status;
    }

    /** Shows a message in the status bar. */
    public void status(Words words) {
        status = words;
        tell(Change.STATUS);
    }

    /** Returns the text that was copied last. */
    public String clipboard() {
        return clipboard;
    }

    public void clipboard(String text) {
        clipboard = text;
    }

    /** Sets what plays the level; without it, as in a script, nothing does. */
    public void playsWith(Consumer<WarmGame.Request> player) {
        game = player;
    }

    /** Plays the level as it is now, saved or not. */
    public void play(WarmGame.Request request) {
        game.accept(request);
    }
}
