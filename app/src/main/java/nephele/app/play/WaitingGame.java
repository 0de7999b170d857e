package nephele.app.play;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import nephele.app.play.hud.HudContent.Page;
import nephele.app.settings.Settings;
import nephele.app.window.GameWindow;
import nephele.app.window.Input;
import nephele.app.window.Screenshots;
import nephele.app.window.Size;
import nephele.editor.play.PlayAnswer;
import nephele.editor.play.PlayEnd;
import nephele.editor.play.PlayOrder;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.PlayerStart;
import nephele.engine.render.gl.GlContext;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.sim.state.PlayerState;
import nephele.host.draw.FollowingBake;
import nephele.host.draw.Preparation;
import nephele.host.draw.QualityChoice;
import nephele.host.named.LevelName;
import nephele.host.named.LevelTitles;
import nephele.host.named.OpenedLevel;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;

/**
 * The game for the editor, in a process of its own: it opens an invisible window, loads a level to warm its classes and
 * programs, and then plays what its input orders, one line an order. It ends with its input, so that it never outlives
 * the editor.
 */
public final class WaitingGame implements AutoCloseable {
    /** A level with most of what levels require: portals, lamps, the sky and textures. */
    private static final String WARMING = "levels/samples/portals.json";

    private static final double PREPARATION_WAIT_SECONDS = 0.005;
    private static final long LONGEST_END_SECONDS = 5;
    private static final int WARMING_FRAMES = 3;
    private static final int WARMING_TICKS = 240;

    private final PlayRequest usual;
    private final OrderQueue orders;
    private final PrintStream answers;
    private final GameWindow window;
    private final GlContext gl;
    private final Input input;
    private final Message message;
    private final Display display;
    private final AutoQuality auto;
    private final CurrentLevel current;
    private final GamePicture picture;

    /** The last played level; {@code null} before the first play. */
    private LevelName lastPlayed;

    private BakedLight lastLight;

    private WaitingGame(
            PlayRequest usual, GameWindow window, GlContext gl, Input input, OrderQueue orders, PrintStream answers) {
        this.usual = usual;
        this.window = window;
        this.gl = gl;
        this.input = input;
        this.orders = orders;
        this.answers = answers;
        var files = usual.player().files();
        message = new Message(() -> files.settings().get(Settings.LANGUAGE));
        display = new Display(window, gl, Screenshots.inUsualFolder(), message);
        auto = new AutoQuality(files, gl.limits(), usual.player().log());
        current = new CurrentLevel(gl, new Recordings(null), message, auto);
        picture = new GamePicture(
                display,
                current,
                new MenuControl(input, System::nanoTime),
                message,
                files,
                input,
                LevelTitles.OF_FILES);
        input.bind(Settings.bindings(files.settings()));
        window.verticalSync(files.settings().get(Settings.VERTICAL_SYNC) == Settings.Switch.ON);
    }

    /**
     * Carries out orders until the input ends.
     *
     * @param usual what orders do not state; its level is the one to warm with, null for a sample
     */
    public static void run(PlayRequest usual, InputStream in, PrintStream answers) {
        System.setProperty("java.awt.headless", "true"); // ImageIO writes pictures and must not open a display
        var orders = OrderQueue.reading(in, WaitingGame::endAtLast);
        var input = new Input();
        var size = new Size(usual.picture().width(), usual.picture().height());
        try (var window = GameWindow.openHidden(GameLoop.TITLE, size, input);
                var gl = GlContext.ofCurrent();
                var game = new WaitingGame(usual, window, gl, input, orders, answers)) {
            game.serve();
        }
    }

    @Override
    public void close() {
        try {
            current.close();
        } finally {
            display.close();
        }
    }

    /** Ends a process that is still busy some seconds after its input ended. */
    private static void endAtLast() {
        try {
            TimeUnit.SECONDS.sleep(LONGEST_END_SECONDS);
        } catch (InterruptedException atOnce) {
            Thread.currentThread().interrupt();
        }
        Runtime.getRuntime().halt(ExitCode.ENVIRONMENT.number());
    }

    private void serve() {
        if (!orders.isAnyWaiting()) {
            warm();
        }
        answer(new PlayAnswer.Ready());
        rest();
        for (var entry = orders.take(); !(entry instanceof OrderQueue.Leave); entry = orders.take()) {
            if (entry instanceof OrderQueue.Ordered ordered) {
                obey(ordered);
            } else if (entry instanceof OrderQueue.Rejected rejected) {
                answer(new PlayAnswer.Failed(rejected.message()));
            }
            rest();
        }
    }

    /** Gives back the level's memory while nobody plays; compiled programs and loaded classes stay. */
    private void rest() {
        picture.levelEnds();
        current.leave();
        message.clear();
        if (!orders.isAnyWaiting()) {
            System.gc();
        }
    }

    private void answer(PlayAnswer answer) {
        answers.println(answer.line());
    }

    /** Loads and draws a level, so that its classes are loaded and its programs compiled; its failure only costs time. */
    private void warm() {
        try {
            var name = usual.level() == null ? new LevelName(WARMING) : usual.level();
            var request = usual.of(name);
            auto.levelBegins(request, pixels());
            current.become(Session.load(
                    gl,
                    request,
                    Preparation.beginUnbaked(name::open, request.chosenQuality(), () -> null),
                    input,
                    auto.of(request)));
            for (int frame = 0; frame < WARMING_FRAMES; frame++) {
                current.session().walk().advance(WARMING_TICKS * 1_000_000_000L / 120 / WARMING_FRAMES);
                picture.draw(GameStage.RUNNING, null, Page.NONE, Display.Shot.NONE);
            }
            gl.finish();
        } catch (RuntimeException problem) {
            if (Loading.problemLine(problem).isEmpty()) {
                throw problem;
            }
        }
    }

    private void obey(OrderQueue.Ordered ordered) {
        try {
            if (load(ordered.order())) {
                play(ordered);
            }
        } catch (RuntimeException problem) {
            fail(problem);
        }
    }

    /** Tells why an order failed; not if the next one is there already, for which its snapshot may have been deleted. */
    private void fail(RuntimeException problem) {
        String message = problem instanceof CommandFailure known
                ? known.getMessage()
                : Loading.problemLine(problem).orElseThrow(() -> problem);
        if (!orders.isAnyWaiting()) {
            answer(new PlayAnswer.Failed(message));
        }
    }

    /** Loads the ordered level; returns false if the next order came before. */
    private boolean load(PlayOrder order) {
        PlayRequest request = request(order);
        var preparation = Preparation.beginUnbaked(
                () -> opened(order), request.chosenQuality(), () -> formerLight(request.level()));
        while (!preparation.isDone()) {
            window.waitForEvents(PREPARATION_WAIT_SECONDS);
            if (orders.isAnyWaiting()) {
                return false;
            }
        }
        var prepared = preparation.get();
        PlayerStart from = order.from() == null ? null : prepared.world().freeStart(order.from());
        auto.levelBegins(request, pixels());
        current.become(Session.load(gl, request.from(from), prepared, input, auto.of(request)));
        return true;
    }

    private long pixels() {
        return (long) window.width() * window.height();
    }

    private PlayRequest request(PlayOrder order) {
        QualityChoice quality =
                order.quality() == null ? usual.quality() : new QualityChoice(order.quality(), Map.of());
        if (quality != null) {
            quality.check();
        }
        return new PlayRequest(
                new LevelName(order.level()),
                order.from(),
                quality,
                null,
                order.record() == null ? null : Path.of(order.record()),
                usual.simulation(),
                null,
                usual.picture(),
                usual.player());
    }

    private static OpenedLevel opened(PlayOrder order) {
        return new LevelName(order.level()).openCopy(Path.of(order.snapshot()));
    }

    /** Returns the light of the last play, if that was an earlier state of the level; otherwise that of its file. */
    private BakedLight formerLight(LevelName level) {
        return level.equals(lastPlayed)
                ? lastLight
                : FollowingBake.lightOf(level).orElse(null);
    }

    private void play(OrderQueue.Ordered ordered) {
        var reports = new TestPlay.Reports(
                orders::isAnyWaiting,
                () -> {
                    gl.finish();
                    answer(new PlayAnswer.Playing((System.nanoTime() - ordered.nanos()) / 1_000_000));
                },
                percent -> answer(new PlayAnswer.Baking(percent)));
        var finished = new TestPlay(window, input, current, picture, message, reports).run();
        lastPlayed = current.session().request().level();
        lastLight = current.session().prepared().scene().light();
        Optional<Path> recorded = record(finished);
        answer(new PlayAnswer.Ended(end(finished, recorded)));
    }

    /** Writes the solution: a walk that reached the exit, or any walk in a level that has none. */
    private Optional<Path> record(Optional<FinishedRun> finished) {
        var session = current.session();
        Path file = session.request().record();
        if (file == null || finished.isEmpty() && !session.level().exits().isEmpty()) {
            return Optional.empty();
        }
        try {
            AtomicFile.write(file, session.trackedRecording().write().getBytes(StandardCharsets.UTF_8));
        } catch (IOException failure) {
            throw CommandFailure.environment(failure.getMessage(), failure);
        }
        return Optional.of(file);
    }

    private PlayEnd end(Optional<FinishedRun> finished, Optional<Path> recorded) {
        PlayerState player = current.session().walk().state().player();
        var heading = player.heading();
        return new PlayEnd(
                new PlayerStart(
                        player.feet(), heading.yawMillidegrees() / 1000.0, heading.pitchMillidegrees() / 1000.0),
                finished.isPresent(),
                finished.map(run -> run.ticks() / 120.0).orElse(0.0),
                finished.map(FinishedRun::portals).orElse(0),
                recorded.map(Path::toString).orElse(null));
    }
}
