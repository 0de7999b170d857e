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
import nephele.editor.document.Selection;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneLayout;
import nephele.editor.play.WarmGame;
import nephele.editor.proving.Proving;
import nephele.editor.proving.ProvingSubject;
import nephele.editor.save.DocumentFile;
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
public final class EditorSession implements ProvingSubject {
    private final Document document;
    private final ToolOptions options = new ToolOptions();
    private final ToolContext context;
    private final Proving proving;
    private final ToolDrag drag;
    private final PaintedMaps maps = new PaintedMaps(() -> file().path());
    private final List<Consumer<SessionChange>> listeners = new ArrayList<>();
    private FileServices fileServices = FileServices.ofThisUser();
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
    /** Whether light is baked in the background, as the user chose; {@code null} if it depends on the level. */
    private Boolean bakesLight;

    private boolean hasBakedLight;
    private Words bake = Words.NONE;
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
        proving = new Proving(this);
        drag = new ToolDrag(this);
        document.listen((before, after) -> tell(SessionChange.DOCUMENT));
        document.onRefusal(this::status);
        toolEntry = Tools.ALL.get(0);
        tool = toolEntry.make().apply(context);
    }

    /** Registers a listener until the registration is closed. */
    public Registration listen(Consumer<SessionChange> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /** Notifies all listeners of a change. */
    public void tell(SessionChange change) {
        if (change != SessionChange.STATUS && change != SessionChange.SETTINGS) {
            proving.follow();
        }
        List.copyOf(listeners).forEach(listener -> listener.accept(change));
    }

    public Document document() {
        return document;
    }

    @Override
    public Level level() {
        return document.level();
    }

    @Override
    public Selection selection() {
        return document.selection();
    }

    @Override
    public boolean isSettled() {
        return !document.isDragging();
    }

    @Override
    public void panes(PaneLayout layout) {
        panes(before -> layout);
    }

    @Override
    public void redraw() {
        tell(SessionChange.VIEW);
    }

    /** Returns the drag of the tool in use. */
    public ToolDrag drag() {
        return drag;
    }

    public ToolContext context() {
        return context;
    }

    /** Returns what runs the reading of files. */
    @Override
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

    @Override
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
        bakesLight = null;
        hasBakedLight = false;
        document.reset(level);
        tell(SessionChange.FILE);
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
        tell(SessionChange.FILE);
    }

    /** Notes what the file on disk holds now, of which the user knows; the document stays as it is. */
    public void known(DocumentFile outside) {
        file = outside;
        tell(SessionChange.FILE);
    }

    public FileServices fileServices() {
        return fileServices;
    }

    public void fileServices(FileServices next) {
        fileServices = next;
    }

    /** Makes the pictures and meshes be read again, since a file has changed. */
    public void reloadAssets(LevelAssets fresh) {
        follow(fresh);
        tell(SessionChange.VIEW);
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
        tell(SessionChange.SETTINGS);
    }

    @Override
    public Language language() {
        return settings.get(EditorSetting.LANGUAGE);
    }

    public Grid grid() {
        return grid;
    }

    public void grid(Grid next) {
        grid = next;
        tell(SessionChange.VIEW);
    }

    @Override
    public PaneLayout panes() {
        return panes;
    }

    public void panes(UnaryOperator<PaneLayout> change) {
        panes = change.apply(panes);
        tell(SessionChange.VIEW);
    }

    /** Returns the size of the whole viewport in pixels. */
    @Override
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
        tell(SessionChange.VIEW);
    }

    public Words status() {
        return status;
    }

    /** Shows a message in the status bar. */
    @Override
    public void status(Words words) {
        status = words;
        tell(SessionChange.STATUS);
    }

    /** Returns true if light that bounces is baked in the background: as chosen, or if the level came with such light. */
    public boolean bakesLight() {
        return bakesLight == null ? hasBakedLight : bakesLight;
    }

    public void bakesLight(boolean next) {
        bakesLight = next;
        tell(SessionChange.VIEW);
    }

    /** Notes that the open level came with light that was baked. */
    public void foundBakedLight() {
        if (!hasBakedLight) {
            hasBakedLight = true;
            tell(SessionChange.VIEW);
        }
    }

    /** Returns how far the bake of light is; empty if none runs. */
    public Words bake() {
        return bake;
    }

    public void bake(Words progress) {
        if (!progress.equals(bake)) {
            bake = progress;
            tell(SessionChange.STATUS);
        }
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
