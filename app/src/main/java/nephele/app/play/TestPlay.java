package nephele.app.play;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import nephele.app.play.hud.HudContent.Page;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.GameWindow;
import nephele.app.window.Gamepad;
import nephele.app.window.Input;
import nephele.app.window.PadState;
import nephele.engine.level.Language;
import nephele.host.draw.FollowingBake;

/** A play of one level from the editor: no menus, Esc ends it. The level is loaded already. */
final class TestPlay {
    private static final double HIDDEN_WAIT_SECONDS = 0.1;
    private static final double LONGEST_PAD_SECONDS = 0.25;
    private static final int SHOWN_PERCENT = 100;
    private static final int STEP_PERCENT = 10;

    private final GameWindow window;
    private final Input input;
    private final Gamepad gamepad;
    private final CurrentLevel current;
    private final GamePicture picture;
    private final Message message;
    private final Reports reports;
    private final RunCounter counter = new RunCounter();
    private final SlowAdvice slow = new SlowAdvice();
    private final FrameCap frameCap = new FrameCap();
    private Page page = Page.NONE;
    private Display.Shot shot = Display.Shot.NONE;
    private Optional<FinishedRun> finished = Optional.empty();
    private boolean isLeft;
    private int reportedPercent;
    private long lastNanos = System.nanoTime();

    /**
     * The callbacks of a test play.
     *
     * @param isReplaced true when another level shall be played
     * @param firstShown runs after the first frame is on the screen
     * @param baking receives the percentage of the baked light
     */
    record Reports(BooleanSupplier isReplaced, Runnable firstShown, IntConsumer baking) {}

    TestPlay(
            GameWindow window,
            Input input,
            CurrentLevel current,
            GamePicture picture,
            Message message,
            Reports reports) {
        this.window = window;
        this.input = input;
        this.current = current;
        this.picture = picture;
        this.message = message;
        this.reports = reports;
        gamepad = new Gamepad(input);
    }

    /** Plays until the player leaves, or until the exit if a solution is recorded. Returns the run to the exit, if any. */
    Optional<FinishedRun> run() {
        picture.levelBegins();
        window.reveal();
        picture.announce();
        picture.draw(GameStage.RUNNING, null, page, shot);
        reports.firstShown.run();
        lastNanos = System.nanoTime();
        try (var bake = current.session().bake()) {
            while (!isLeft && !reports.isReplaced.getAsBoolean()) {
                frame(bake);
            }
        } finally {
            window.hide();
        }
        return finished;
    }

    private void frame(FollowingBake bake) {
        poll();
        for (var key = input.nextPressed(); key != null; key = input.nextPressed()) {
            obey(key);
        }
        simulate();
        relight(bake);
        if (window.isDrawable()) {
            picture.draw(GameStage.RUNNING, null, page, shot);
            shot = Display.Shot.NONE;
        }
        frameCap.await(files().settings().get(Settings.FRAME_CAP));
    }

    private PlayerFiles files() {
        return current.session().request().player().files();
    }

    private void poll() {
        window.poll();
        gamepad.update(
                window.hasFocus() ? window.pad() : PadState.RELEASED,
                Gamepad.Use.PLAY,
                Math.min(LONGEST_PAD_SECONDS, (System.nanoTime() - lastNanos) / 1e9));
        if (!window.isDrawable()) {
            window.waitForEvents(HIDDEN_WAIT_SECONDS);
        }
        isLeft |= window.closeRequested();
        window.captureMouse(window.hasFocus());
    }

    private void obey(Control key) {
        switch (key) {
            case MENU -> {
                isLeft |= page == Page.NONE;
                page = Page.NONE;
            }
            case RESTART -> restart();
            case PERSON -> current.session().walk().changePerson();
            case SCREENSHOT ->
                shot = input.holds(Control.RUN) ? Display.Shot.WITHOUT_OVERLAY : Display.Shot.WITH_OVERLAY;
            case HINT -> picture.giveHint();
            case FIGURES -> current.toggleFigures();
            case HELP -> page = page == Page.HELP ? Page.NONE : Page.HELP;
            default -> {}
        }
    }

    private void restart() {
        current.restart();
        counter.restart();
        slow.restart();
        picture.levelBegins();
        finished = Optional.empty();
    }

    /** Simulates the time since the last frame; without the focus the level stands still. */
    private void simulate() {
        long now = System.nanoTime();
        long elapsed = now - lastNanos;
        lastNanos = now;
        if (!window.hasFocus()) {
            return;
        }
        var walk = current.session().walk();
        walk.advance(elapsed);
        var events = walk.takeEvents();
        Language language = files().settings().get(Settings.LANGUAGE);
        if (!events.isEmpty()) {
            events.forEach(event -> Message.ofEvent(event, language).ifPresent(message::say));
            picture.after(events);
        }
        slow.say(now, current, window, files().settings(), message);
        counter.after(events, walk).ifPresent(run -> finish(run, language));
    }

    private void finish(FinishedRun run, Language language) {
        finished = Optional.of(run);
        isLeft |= current.session().request().record() != null;
        message.say(Phrase.EXIT_REACHED.in(language) + ": " + PageWriter.time(run.ticks()));
    }

    private void relight(FollowingBake bake) {
        if (reportedPercent == SHOWN_PERCENT) {
            return;
        }
        if (bake.isDone()) {
            boolean wasNeeded = current.session().isOtherLight(bake.scene());
            current.relight(bake.scene());
            reportedPercent = SHOWN_PERCENT;
            if (wasNeeded) {
                reports.baking.accept(SHOWN_PERCENT);
            }
        } else if (bake.percent() >= reportedPercent + STEP_PERCENT) {
            reportedPercent = Math.min(bake.percent(), SHOWN_PERCENT - 1);
            reports.baking.accept(reportedPercent);
        }
    }
}
