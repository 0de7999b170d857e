package nephele.editor.action;

import java.nio.file.Path;
import java.util.List;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.play.PlayText;
import nephele.editor.play.SolutionCheck;
import nephele.editor.play.WarmGame;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.PlayerStart;
import nephele.engine.sim.state.SimLevel;

/** Playing the level as it is, from the camera's place or from its start, and recording a solution. */
final class PlayActions {
    private static final Words UNSAVED = Words.of(
            "save the level first: its solution is kept beside it",
            "salve a fase antes: a solução fica ao lado dela",
            "guarda primeiro o nível: a solução fica ao lado dele");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of(
                            "play-here",
                            Words.of("Play from Here", "Jogar daqui", "Jogar daqui"),
                            Menu.PLAY,
                            List.of("F5"),
                            call -> play(call.session(), here(call.session()), null))
                    .changing(Subject.WINDOW),
            EditorAction.of(
                            "play-start",
                            Words.of("Play from the Start", "Jogar do início", "Jogar do início"),
                            Menu.PLAY,
                            List.of("Shift+F5"),
                            call -> play(call.session(), null, null))
                    .changing(Subject.WINDOW),
            EditorAction.of(
                            "record-solution",
                            Words.of("Record a Solution", "Gravar uma solução", "Gravar uma solução"),
                            Menu.PLAY,
                            List.of("F6"),
                            PlayActions::record)
                    .changing(Subject.WINDOW));

    private PlayActions() {}

    /** Returns the start below the camera of the perspective pane. */
    private static PlayerStart here(EditorSession session) {
        PerspectiveCamera camera = session.panes().eye();
        return SimLevel.startBelow(camera.eye(), camera.yawDegrees(), camera.pitchDegrees());
    }

    private static void record(ActionCall call) throws EditorRefusal {
        Path file = call.session().file().path().orElseThrow(() -> new EditorRefusal(UNSAVED));
        play(call.session(), null, SolutionCheck.fileOf(file));
    }

    private static void play(EditorSession session, PlayerStart from, Path record) {
        session.status(PlayText.STARTING.words());
        Path file = session.file().path().orElse(Path.of("untitled.json"));
        session.play(new WarmGame.Request(session.document().level(), file, from, null, record));
    }
}
