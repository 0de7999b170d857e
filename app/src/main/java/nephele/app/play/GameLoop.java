package nephele.app.play;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import nephele.app.play.hud.HudContent.Page;
import nephele.app.play.hud.Menu;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Progress;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.GameWindow;
import nephele.app.window.Gamepad;
import nephele.app.window.Input;
import nephele.app.window.PadState;
import nephele.app.window.Screenshots;
import nephele.app.window.Size;
import nephele.app.window.SystemDisplay;
import nephele.app.window.WindowMode;
import nephele.engine.level.Language;
import nephele.engine.render.gl.GlContext;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.named.LevelTitles;
import nephele.host.terminal.CommandFailure;

/** The game loop, from the title to the end: the work of a frame, and the transitions between stages. */
public final class GameLoop implements AutoCloseable {
    private static final double HIDDEN_WAIT_SECONDS = 0.1;
    private static final double PREPARATION_WAIT_SECONDS = 0.02;
    /** The longest time for which a stick turns the view in one frame, so that loading a level is no turn. */
    private static final double LONGEST_PAD_SECONDS = 0.25;

    static final String TITLE = "Nephele";

    private final GameWindow window;
    private final GlContext gl;
    private final Input input;
    private final Gamepad gamepad;
    private final PlayerFiles files;
    private final Display display;
    private final StageMachine stages;
    private final GameMenus menus;
    private final MenuControl menu;
    private final Message message = new Message(this::language);
    private final AutoQuality auto;
    private final CurrentLevel current;
    private final GamePicture picture;
    private final SettingsControl settings;
    private final RunCounter counter = new RunCounter();
    private final SlowAdvice slow = new SlowAdvice();
    private final FrameCap frameCap = new FrameCap();
    private final PlayRequest first;
    private final LevelTitles titles = LevelCatalogue.titles();
    private Loading loading;

    /** The stage whose menu has started the level that is being loaded; null if the command line has. */
    private GameStage startedFrom;

    private Page page = Page.NONE;
    private Display.Shot shot = Display.Shot.NONE;
    private long lastNanos = System.nanoTime();

    /** Starts to read the level, or opens the title; {@link #run} plays. */
    public GameLoop(PlayRequest request, GameWindow window, GlContext gl, Input input) {
        first = request;
        this.window = window;
        this.gl = gl;
        this.input = input;
        files = request.player().files();
        stages = new StageMachine(request.player().log());
        menus = new GameMenus(files, LevelCatalogue.campaign(), titles, input::device);
        gamepad = new Gamepad(input);
        menu = new MenuControl(input, System::nanoTime);
        auto = new AutoQuality(files, gl.limits(), request.player().log());
        current = new CurrentLevel(gl, new Recordings(request.record()), message, auto);
        display = new Display(window, gl, Screenshots.inUsualFolder(), message);
        settings = new SettingsControl(window, input, menus, menu, current, message);
        picture = new GamePicture(display, current, menu, message, files, input, titles);
        settings.applyVerticalSync();
        if (window.mode() == WindowMode.WINDOWED && files.settings().get(Settings.WINDOW_MODE) != WindowMode.WINDOWED) {
            settings.applyMode();
        }
        if (request.level() == null) {
            openTitle();
        } else {
            start(request);
        }
    }

    /**
     * Plays in a window of its own until the player quits.
     *
     * @param loaded is called when the level is loaded
     */
    public static void play(PlayRequest request, Runnable loaded) {
        var input = new Input();
        try (var window = open(request, input);
                var gl = GlContext.ofCurrent();
                var loop = new GameLoop(request, window, gl, input)) {
            loaded.run();
            loop.run();
        }
    }

    /** Opens a window, draws only the first frame and reports the time of each part of the start. */
    public static void profileStart(PlayRequest request, StartProfile profile, PrintStream out) {
        profile.done("arguments");
        var input = new Input();
        try (var window = open(request, input);
                var gl = GlContext.ofCurrent()) {
            profile.done("window and context");
            try (var loop = new GameLoop(request, window, gl, input)) {
                loop.frame();
                gl.finish();
                profile.done("level, upload, compile and first frame");
                profile.report().forEach(out::println);
            }
        }
    }

    private static GameWindow open(PlayRequest request, Input input) {
        System.setProperty("java.awt.headless", "true"); // ImageIO writes pictures and must not open a display
        var picture = request.picture();
        var window = GameWindow.open(TITLE, new Size(picture.width(), picture.height()), input);
        if (picture.fullScreen()) {
            window.become(
                    WindowMode.FULLSCREEN,
                    Settings.resolution(request.player().files().settings()));
        }
        return window;
    }

    /** Runs until the player quits. */
    public void run() {
        while (!stages.in(GameStage.LEAVING)) {
            frame();
        }
    }

    /** Runs one frame. */
    void frame() {
        poll();
        obeyKeys();
        picture.moveWipe(stages.current(), (System.nanoTime() - lastNanos) / 1e9);
        obeyPointer();
        refreshMenu();
        changeLevel();
        simulate();
        draw();
        stages.logVisible(menu, loading, current);
        reportProblems();
        frameCap.await(files.settings().get(Settings.FRAME_CAP));
    }

    GameStage stage() {
        return stages.current();
    }

    boolean showsHelp() {
        return page == Page.HELP;
    }

    boolean showsFigures() {
        return current.figures().isOpen();
    }

    private Language language() {
        return files.settings().get(Settings.LANGUAGE);
    }

    private void poll() {
        window.poll();
        gamepad.update(
                window.hasFocus() ? window.pad() : PadState.RELEASED,
                stages.inMenu() ? Gamepad.Use.MENU : Gamepad.Use.PLAY,
                Math.min(LONGEST_PAD_SECONDS, (System.nanoTime() - lastNanos) / 1e9));
        if (!window.isDrawable()) {
            window.waitForEvents(HIDDEN_WAIT_SECONDS);
        }
        if (window.closeRequested() && !stages.in(GameStage.LEAVING)) {
            stages.change(GameStage.LEAVING);
        }
        if (window.takeFocusLoss()
                && stages.in(GameStage.RUNNING)
                && current.session().request().isPlayed()) {
            openPause();
        }
        window.captureMouse(stages.in(GameStage.RUNNING) && window.hasFocus());
    }

    private void obeyKeys() {
        settings.obeyCapturedKey();
        for (var key = input.nextPressed(); key != null; key = input.nextPressed()) {
            switch (key) {
                case FULL_SCREEN -> settings.toggleFullScreen();
                case SCREENSHOT ->
                    shot = input.holds(Control.RUN) ? Display.Shot.WITHOUT_OVERLAY : Display.Shot.WITH_OVERLAY;
                case HELP -> page = page == Page.HELP ? Page.NONE : Page.HELP;
                default -> obeyStageKey(key);
            }
        }
    }

    /** Handles a key of the page, the menu or the game, whichever is on top: what is covered takes none. */
    private void obeyStageKey(Control key) {
        if (page == Page.HELP && (key == Control.MENU || stages.inMenu())) {
            page = key == Control.MENU ? Page.NONE : page;
        } else if (stages.inMenu()) {
            chooseByKey(key);
        } else if (stages.in(GameStage.RUNNING)) {
            obeyGameKey(key);
        }
    }

    private void obeyGameKey(Control key) {
        switch (key) {
            case RESTART -> openMenu(menus.page(Menu.Page.RESTART_QUESTION));
            case PERSON -> current.session().walk().changePerson();
            case HINT -> picture.giveHint();
            case FIGURES -> current.toggleFigures();
            case MENU -> openPause();
            default -> {}
        }
    }

    /**
     * Handles a menu key. A key that chose is released, so that the space bar which continues the game does not also
     * jump.
     */
    private void chooseByKey(Control key) {
        var choice = menu.choiceOf(key);
        if (choice != null) {
            input.key(key, false);
        }
        choose(choice);
    }

    private void openPause() {
        openMenu(pauseMenu());
    }

    /** Opens a menu above the game, to which its first page leads back. */
    private void openMenu(Menu first) {
        page = Page.NONE;
        menu.open(first);
        stages.change(GameStage.MENU);
    }

    private void openTitle() {
        page = Page.NONE;
        menu.open(menus.title());
        picture.titleOpens();
        if (current.session() != null) {
            current.liesBehindTitle();
        } else {
            loading = menus.nextToPlay()
                    .map(level -> Loading.begin(first.of(level)))
                    .orElse(null);
        }
        stages.change(GameStage.TITLE);
    }

    private void obeyPointer() {
        if (stages.inMenu() && page == Page.HELP) {
            page = input.takeClick() == null ? page : Page.NONE;
        } else if (stages.inMenu()) {
            choose(menu.choiceOf(display.area(), display.pixelsPerPoint()));
        }
    }

    /** Shows what has been read for the open page. */
    private void refreshMenu() {
        if (stages.inMenu()) {
            menus.refreshed(menu.page()).ifPresent(menu::rewrite);
        }
    }

    /** @param choice null if nothing was chosen */
    private void choose(Menu.Choice choice) {
        if (choice instanceof Menu.Choice.Plain plain) {
            choose(plain);
        } else if (choice instanceof Menu.Choice.Play next) {
            play(first.of(next.level()));
        } else if (choice instanceof Menu.Choice.Compare next) {
            play(first.of(next.level()).comparing(next.techniques()));
        } else if (choice instanceof Menu.Choice.Show shown) {
            visit(shown.scene());
        } else if (choice instanceof Menu.Choice.ShowFolder shown) {
            show(shown.folder());
        } else if (choice instanceof Menu.Choice.Open open) {
            menu.turnTo(menus.page(open.page()));
        } else if (choice instanceof Menu.Choice.OpenSettings open) {
            menu.turnTo(menus.settings(open.group()));
        } else if (choice instanceof Menu.Choice.OpenSamples open) {
            menu.turnTo(menus.samples(open.group()));
        } else if (choice instanceof Menu.Choice.Bind bind) {
            settings.awaitKey(bind.control());
        } else if (choice instanceof Menu.Choice.Step step) {
            settings.change(step);
            menu.rewriteFirst(firstPage());
        }
    }

    private void choose(Menu.Choice.Plain choice) {
        switch (choice) {
            case RESUME -> leaveMenu(GameStage.RUNNING);
            case RESTART -> leaveMenu(GameStage.RESTARTING);
            case QUIT -> leaveMenu(GameStage.LEAVING);
            case TO_TITLE -> openTitle();
            case BACK -> {
                if (!menu.back()) {
                    leaveMenu(GameStage.RUNNING);
                }
            }
        }
    }

    private void show(Path folder) {
        message.say(SystemDisplay.show(folder) ? folder.toString() : Phrase.FOLDER_NOT_SHOWN.in(language(), folder));
    }

    /** Starts a level; one that is loaded or being loaded already is used. */
    private void play(PlayRequest next) {
        startedFrom = stages.current();
        boolean isLoaded = current.session() != null
                && current.session().request().isPlayedFromStart()
                && current.session().request().shows(next);
        if (isLoaded) {
            leaveMenu(GameStage.RESTARTING);
        } else if (loading != null && loading.request().shows(next)) {
            leaveMenu(GameStage.STARTING);
        } else {
            menu.close();
            start(next);
        }
    }

    /** Shows an XML scene in its viewer until the player leaves it; the menu is then as before. */
    private void visit(String scene) {
        try {
            var screen = new PlayRequest.SceneViewing.Screen(window, input, gl, language());
            first.player().scenes().show(scene, titles.of(scene, language(), scene), screen, message::say);
        } catch (CommandFailure problem) {
            message.say(Phrase.SCENE_NOT_SHOWN, problem.getMessage());
        } catch (RuntimeException problem) {
            message.say(Phrase.SCENE_NOT_SHOWN, Loading.problemLine(problem).orElseThrow(() -> problem));
        }
        window.title(TITLE);
        lastNanos = System.nanoTime();
    }

    private Menu firstPage() {
        return stages.in(GameStage.TITLE) ? menus.title() : pauseMenu();
    }

    private Menu pauseMenu() {
        Session session = current.session();
        return menus.pause(session.request().level(), Captions.goalText(session.level(), language()));
    }

    private void leaveMenu(GameStage stage) {
        menu.close();
        input.forgetMouse();
        input.forgetPresses();
        stages.change(stage);
    }

    private void start(PlayRequest next) {
        loading = Loading.begin(next);
        stages.change(GameStage.STARTING);
    }

    private void changeLevel() {
        if (stages.in(GameStage.STARTING) && loading.isDone()) {
            draw();
            load();
            window.title(TITLE);
        } else if (stages.in(GameStage.STARTING)) {
            window.title(TITLE + " – " + loading.progress(language()));
            window.waitForEvents(PREPARATION_WAIT_SECONDS);
        } else if (stages.in(GameStage.TITLE) && loading != null && loading.isDone() && menu.rests()) {
            loadBehindTitle();
        } else if (stages.in(GameStage.RESTARTING)) {
            current.restart();
            begin();
        }
    }

    /** The level behind the title may be missing: its problem is told when the player starts it. */
    private void loadBehindTitle() {
        try {
            current.become(session());
            current.liesBehindTitle();
        } catch (RuntimeException problem) {
            if (Loading.problemLine(problem).isEmpty()) {
                throw problem;
            }
        }
        loading = null;
    }

    /**
     * Replaces the level. The old one is kept until the new one is complete: after a level that fails the menu that
     * started it is there again.
     */
    private void load() {
        try {
            current.become(session());
            loading = null;
            begin();
        } catch (RuntimeException problem) {
            var reported = Loading.problemLine(problem);
            if (startedFrom == null || reported.isEmpty()) {
                throw problem;
            }
            loading = null;
            message.say(Phrase.NOT_LOADED, reported.get());
            menu.reopen();
            stages.change(startedFrom);
        }
    }

    /** Returns the loaded level as its first frame is drawn; its problems leave the one before as it is. */
    private Session session() {
        var request = loading.request();
        var prepared = loading.prepared();
        auto.levelBegins(request, display.pixels());
        return Session.load(gl, request, prepared, input, auto.of(request));
    }

    private void begin() {
        current.isPlayed(display::firstViewMillis);
        display.rehearse(current.session());
        lastNanos = System.nanoTime();
        counter.restart();
        slow.restart();
        input.forgetPresses();
        picture.levelBegins();
        stages.change(GameStage.RUNNING);
    }

    private void simulate() {
        long now = System.nanoTime();
        if (stages.in(GameStage.RUNNING)) {
            simulate(current.session(), now);
        }
        lastNanos = now;
    }

    private void simulate(Session session, long now) {
        var walk = session.walk();
        walk.advance(now - lastNanos);
        var events = walk.takeEvents();
        if (!events.isEmpty()) {
            events.forEach(event -> Message.ofEvent(event, language()).ifPresent(message::say));
            picture.after(events);
        }
        Optional<FinishedRun> finished = counter.after(events, walk);
        slow.say(now, current, window, files.settings(), message);
        if (finished.isPresent()) {
            end(session, finished.get());
        } else if (walk.isFinished()) {
            message.say(Phrase.REPLAY_OVER);
            openPause();
        }
    }

    /** Ends the level. A replay that is only shown goes on to its last tick. */
    private void end(Session session, FinishedRun run) {
        if (!session.request().isPlayed()) {
            message.say(Phrase.EXIT_REACHED.in(language()) + ": " + PageWriter.time(run.ticks()));
            return;
        }
        LevelName level = session.request().level();
        stages.log("exit " + level.fileName() + " "
                + session.walk().state().world().exit().tick());
        Progress before = files.progress();
        if (session.request().isRanked()) {
            files.keep(before.withFinished(level.key(), run.ticks(), run.portals(), run.hints()));
        }
        page = Page.NONE;
        menu.openUnasked(menus.ended(session.request(), run, before, LevelCatalogue.after(level)));
        stages.change(GameStage.ENDED);
    }

    private void draw() {
        if (!window.isDrawable()) {
            return;
        }
        picture.draw(stages.current(), loading, page, shot);
        shot = Display.Shot.NONE;
    }

    private void reportProblems() {
        List<String> problems = files.takeProblems();
        if (!problems.isEmpty()) {
            problems.forEach(message::say);
        }
    }

    /** Saves the recording, however the game ends. */
    @Override
    public void close() {
        try {
            current.close();
        } finally {
            display.close();
        }
    }
}
