package nephele.app.play;

import nephele.app.play.hud.HudContent;
import nephele.app.play.hud.HudContent.Page;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.SettingsPage;
import nephele.app.window.Control;
import nephele.app.window.GameWindow;
import nephele.app.window.Input;
import nephele.app.window.Screenshots;
import nephele.engine.render.gl.GlContext;

/** The game loop, from the first level to the end: the work of a frame, and the transitions between stages. */
public final class GameLoop implements AutoCloseable {
    private static final double HIDDEN_WAIT_SECONDS = 0.1;
    private static final double PREPARATION_WAIT_SECONDS = 0.02;
    static final String TITLE = "Nephele";

    private final GameWindow window;
    private final GlContext gl;
    private final Input input;
    private final Display display;
    private final StageMachine stages = new StageMachine();
    private final MenuControl menu;
    private final Message message = new Message();
    private final CurrentLevel current;
    private PlayRequest request;
    private Loading loading;

    private Page page = Page.NONE;
    private Display.Shot shot = Display.Shot.NONE;
    private long lastNanos;

    /** Starts to read the level; {@link #run} plays it. */
    public GameLoop(PlayRequest request, GameWindow window, GlContext gl, Input input) {
        this.request = request;
        this.window = window;
        this.gl = gl;
        this.input = input;
        menu = new MenuControl(input);
        current = new CurrentLevel(gl, new Recordings(request.record()), message);
        display = new Display(window, gl, Screenshots.inUsualFolder());
        start(request);
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
        obeyPointer();
        changeLevel();
        simulate();
        draw();
    }

    GameStage stage() {
        return stages.current();
    }

    private void poll() {
        window.poll();
        if (!window.isDrawable()) {
            window.waitForEvents(HIDDEN_WAIT_SECONDS);
        }
        if (window.closeRequested() && !stages.in(GameStage.LEAVING)) {
            stages.change(GameStage.LEAVING);
        }
        window.captureMouse(stages.in(GameStage.RUNNING) && window.hasFocus());
    }

    private void obeyKeys() {
        for (var key = input.nextPressed(); key != null; key = input.nextPressed()) {
            switch (key) {
                case FULL_SCREEN -> window.toggleFullScreen();
                case SCREENSHOT ->
                    shot = input.holds(Control.RUN) ? Display.Shot.WITHOUT_OVERLAY : Display.Shot.WITH_OVERLAY;
                case FIGURES -> current.toggleFigures();
                case HELP -> page = page == Page.HELP ? Page.NONE : Page.HELP;
                default -> obeyStageKey(key);
            }
        }
    }

    private void obeyStageKey(Control key) {
        if (stages.in(GameStage.MENU)) {
            chooseByKey(key);
        } else if (stages.in(GameStage.RUNNING) && key == Control.RESTART) {
            stages.change(GameStage.RESTARTING);
        } else if (stages.in(GameStage.RUNNING) && key == Control.PERSON) {
            current.session().walk().changePerson();
        } else if (stages.in(GameStage.RUNNING) && key == Control.MENU) {
            openMenuOrClosePage();
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

    private void openMenuOrClosePage() {
        if (page != Page.NONE) {
            page = Page.NONE;
            return;
        }
        menu.open();
        stages.change(GameStage.MENU);
    }

    private void obeyPointer() {
        if (stages.in(GameStage.MENU)) {
            choose(menu.choiceOf(display.area(), window.scale()));
        }
    }

    /** @param choice null if nothing was chosen */
    private void choose(Menu.Choice choice) {
        if (choice instanceof Menu.Choice.Continue) {
            resume(GameStage.RUNNING);
        } else if (choice instanceof Menu.Choice.Restart) {
            resume(GameStage.RESTARTING);
        } else if (choice instanceof Menu.Choice.Quit) {
            resume(GameStage.LEAVING);
        } else if (choice instanceof Menu.Choice.Start next) {
            menu.close();
            start(request.of(next.level()));
        } else if (choice instanceof Menu.Choice.ShowSettings) {
            menu.turnTo(SettingsPage.of(request.simulation()));
        } else if (choice instanceof Menu.Choice.TurnUpright asked) {
            turnUpright(asked.degreesPerSecond());
        }
    }

    /**
     * Changes the rate at which the view turns upright, from the next start on. A running walk keeps its rate, as its
     * recording stores one for all of it.
     */
    private void turnUpright(int degreesPerSecond) {
        request = request.with(request.simulation().withUprightDegreesPerSecond(degreesPerSecond));
        menu.rewrite(SettingsPage.of(request.simulation()));
        message.say("Upright " + SettingsPage.inWords(degreesPerSecond) + " "
                + current.session().settingsHold());
    }

    private void resume(GameStage stage) {
        menu.close();
        input.forgetMouse();
        stages.change(stage);
    }

    private void start(PlayRequest next) {
        request = next;
        loading = Loading.begin(next);
        stages.change(GameStage.STARTING);
    }

    private void changeLevel() {
        if (stages.in(GameStage.STARTING)) {
            loadWhenPrepared();
        } else if (stages.in(GameStage.RESTARTING)) {
            current.restart(request.simulation());
            stages.change(GameStage.RUNNING);
        }
    }

    private void loadWhenPrepared() {
        if (loading.isDone()) {
            load();
            window.title(TITLE);
            return;
        }
        loading.progress().ifPresent(baked -> {
            message.say(baked);
            window.title(TITLE + " – " + baked);
        });
        window.waitForEvents(PREPARATION_WAIT_SECONDS);
    }

    /**
     * Replaces the level. The old one is kept until the new one is complete: after a level that fails the menu opens.
     */
    private void load() {
        try {
            current.become(loading.session(gl, input));
            lastNanos = System.nanoTime();
            stages.change(GameStage.RUNNING);
        } catch (RuntimeException problem) {
            var told = LoadProblem.line(problem);
            if (current.session() == null || told.isEmpty()) {
                throw problem;
            }
            message.say(told.get());
            menu.open();
            stages.change(GameStage.MENU);
        }
    }

    private void simulate() {
        long now = System.nanoTime();
        if (stages.in(GameStage.RUNNING)) {
            var walk = current.session().walk();
            walk.advance(now - lastNanos);
            walk.takeEvents().forEach(event -> EventText.of(event).ifPresent(message::say));
            if (walk.isFinished()) {
                message.say("The replay is over");
                openMenuOrClosePage();
            }
        }
        lastNanos = now;
    }

    private void draw() {
        var session = current.session();
        if (session == null || !window.isDrawable()) {
            return;
        }
        var area = display.area();
        var content = new HudContent(
                menu.page(),
                page,
                current.figures().lines(),
                message.text(),
                session.walk().sights(area.width(), area.height()));
        var saved = display.draw(session, content, current.figures().frameBegins(), shot);
        shot = Display.Shot.NONE;
        if (saved != null) {
            message.say(saved);
        }
        current.figures().frameEnds(session.walk());
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
