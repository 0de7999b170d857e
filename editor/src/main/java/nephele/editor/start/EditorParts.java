package nephele.editor.start;

import java.util.List;
import java.util.Optional;
import javax.swing.JTabbedPane;
import nephele.editor.action.Actions;
import nephele.editor.action.Desk;
import nephele.editor.command.EditorCommands;
import nephele.editor.document.Selection;
import nephele.editor.panel.HistoryPanel;
import nephele.editor.panel.InspectorPanel;
import nephele.editor.panel.OutlinerPanel;
import nephele.editor.panel.PalettePanel;
import nephele.editor.panel.ProblemsPanel;
import nephele.editor.panel.model.PanelText;
import nephele.editor.problem.LevelProblem;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.session.SessionListener.Change;
import nephele.editor.surface.SurfaceMode;
import nephele.editor.text.Words;
import nephele.editor.toolbox.Tools;
import nephele.editor.window.EditorPanel;
import nephele.editor.window.EditorSlots;

/** Puts the panels around the viewport. */
final class EditorParts {
    private static final List<String> MAIN_ACTIONS = List.of("new", "open", "save", "undo", "redo", "play-here");
    private static final Words OUTLINE = Words.of("Level", "Fase", "Nível");
    private static final Words PALETTE = Words.of("Add", "Adicionar", "Adicionar");

    private EditorParts() {}

    static EditorPanel panel(EditorSession session, Desk desk, SurfaceMode surface) {
        EditorCommands commands = new EditorCommands(session, desk, Actions.ALL, Tools.ALL);
        JTabbedPane left = new JTabbedPane();
        left.addTab("", new OutlinerPanel(session, ref -> focus(commands, session, ref)));
        left.addTab("", new PalettePanel(session));
        JTabbedPane bottom = new JTabbedPane();
        bottom.addTab("", new ProblemsPanel(session, problem -> choose(session, problem)));
        bottom.addTab("", new HistoryPanel(session));
        Runnable titles = () -> {
            title(left, session, OUTLINE, PALETTE);
            title(bottom, session, PanelText.PROBLEMS.words(), PanelText.HISTORY.words());
        };
        titles.run();
        session.listen(change -> {
            if (change == Change.SETTINGS) {
                titles.run();
            }
        });
        EditorSlots slots =
                new EditorSlots(left, new InspectorPanel(session, current -> Optional.empty()), bottom, MAIN_ACTIONS);
        return new EditorPanel(session, commands, surface, slots);
    }

    private static void title(JTabbedPane tabs, EditorSession session, Words... titles) {
        for (int i = 0; i < titles.length; i++) {
            tabs.setTitleAt(i, titles[i].in(session.language()));
        }
    }

    private static void focus(EditorCommands commands, EditorSession session, EntityRef ref) {
        session.document().select(Selection.of(ref));
        commands.named("focus").ifPresent(command -> command.run());
    }

    private static void choose(EditorSession session, LevelProblem problem) {
        if (problem.entity() != null) {
            session.document().select(Selection.of(problem.entity()));
        }
    }
}
