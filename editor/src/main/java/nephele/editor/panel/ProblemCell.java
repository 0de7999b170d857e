package nephele.editor.panel;

import java.awt.Component;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import nephele.editor.panel.model.PanelText;
import nephele.editor.problem.LevelProblem;
import nephele.editor.session.EditorSession;

/** Paints a problem: severity, message, entity. */
final class ProblemCell extends DefaultListCellRenderer {
    private final transient EditorSession session;

    ProblemCell(EditorSession session) {
        this.session = session;
    }

    @Override
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean isSelected, boolean hasFocus) {
        super.getListCellRendererComponent(list, "", index, isSelected, hasFocus);
        LevelProblem problem = (LevelProblem) value;
        String place =
                problem.entity() == null ? problem.path() : problem.entity().text();
        setText(problem.message().in(session.language()) + "  –  " + place);
        setToolTipText(getText());
        PanelText severity =
                switch (problem.severity()) {
                    case ERROR -> PanelText.ERROR;
                    case WARNING -> PanelText.WARNING;
                    case HINT -> PanelText.HINT;
                };
        setIcon(
                switch (problem.severity()) {
                    case ERROR -> PanelIcon.ERROR;
                    case WARNING -> PanelIcon.WARNING;
                    case HINT -> PanelIcon.HINT;
                });
        getAccessibleContext().setAccessibleName(severity.in(session.language()) + ": " + getText());
        return this;
    }
}
