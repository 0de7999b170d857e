package nephele.editor.panel;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import nephele.editor.document.Registration;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.SessionChange;
import nephele.editor.text.Words;
import net.miginfocom.swing.MigLayout;

/** A bar above the viewport with the step of the first room that comes next. It can be left at any time. */
public final class GuideBar extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1;
    private static final Words NAME = Words.of("Your first room", "Sua primeira sala", "A tua primeira sala");
    private static final Words COUNT = Words.of("Step %s of %s", "Passo %s de %s", "Passo %s de %s");
    private static final Words PREPARE = Words.of("Show me", "Mostre", "Mostra-me");
    private static final Words BACK = Words.of("Back", "Voltar", "Voltar");
    private static final Words SKIP = Words.of("Skip", "Pular", "Saltar");
    private static final Words LEAVE = Words.of("Leave the guide", "Sair do guia", "Sair do guia");
    private static final Words READY =
            Words.of("Your first room is ready", "Sua sala está pronta", "A tua sala está pronta");
    private static final Words READY_TEXT = Words.of(
            "F5 plays it. F6 records a solution. Help lists all keys, Ctrl+K finds every command by its name.",
            "F5 joga. F6 grava uma solução. A Ajuda lista as teclas, Ctrl+K encontra cada comando pelo nome.",
            "F5 joga. F6 grava uma solução. A Ajuda lista as teclas, Ctrl+K encontra cada comando pelo nome.");

    private final transient EditorSession session;
    private final transient Guide guide;
    private final transient Registration registration;
    private final JLabel count = new JLabel();
    private final JLabel title = new JLabel();
    private final JTextArea text = new JTextArea();
    private final JButton prepare = button("guide-show", event -> current(GuideStep::prepare));
    private final JButton back = button("guide-back", event -> back());
    private final JButton skip = button("guide-skip", event -> skip());
    private final JButton leave = button("guide-leave", event -> leave());
    private final JPanel buttons = new JPanel(new MigLayout("insets 0"));
    private boolean isNarrow;

    public GuideBar(EditorSession session) {
        super(new MigLayout("insets 6 10 6 8, fillx, hidemode 3", "[][grow, fill][]"));
        this.session = session;
        guide = new Guide(session);
        title.putClientProperty(FlatClientProperties.STYLE_CLASS, "h4");
        count.putClientProperty(FlatClientProperties.STYLE_CLASS, "small");
        text.setEditable(false);
        text.setFocusable(false);
        text.setOpaque(false);
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        for (JButton button : List.of(prepare, back, skip, leave)) {
            buttons.add(button);
        }
        arrange();
        setVisible(false);
        registration = session.listen(this::follow);
    }

    /** Puts the buttons beside the title, or below the text where there is no room. */
    private void arrange() {
        removeAll();
        add(title);
        add(count, isNarrow ? "gapleft 8, span 2, wrap" : "gapleft 8");
        if (!isNarrow) {
            add(buttons, "wrap");
        }
        add(text, "span 3, growx, wmin 100, wrap");
        if (isNarrow) {
            add(buttons, "span 3, right");
        }
    }

    @Override
    public void doLayout() {
        int row = title.getPreferredSize().width + count.getPreferredSize().width + buttons.getPreferredSize().width;
        boolean isFull = row + UIScale.scale(48) > getWidth();
        if (isFull != isNarrow) {
            isNarrow = isFull;
            arrange();
            revalidate();
        }
        super.doLayout();
    }

    private static JButton button(String name, Consumer<Object> action) {
        JButton button = new JButton();
        button.setName(name);
        button.setFocusable(true);
        button.addActionListener(action::accept);
        return button;
    }

    /** Begins with the first step that the level has not done. */
    public void start() {
        guide.start();
        refresh();
    }

    private void leave() {
        guide.leave();
        session.settings(session.settings().with(EditorSetting.GUIDE_FINISHED, true));
        refresh();
    }

    private void skip() {
        guide.next();
        refresh();
    }

    private void back() {
        guide.back();
        refresh();
    }

    private void current(BiConsumer<GuideStep, EditorSession> action) {
        guide.step().ifPresent(step -> action.accept(step, session));
    }

    private void follow(SessionChange change) {
        boolean isNew = (change == SessionChange.DOCUMENT || change == SessionChange.FILE) && guide.follow();
        if (isNew || change == SessionChange.SETTINGS) {
            refresh();
        }
    }

    private void refresh() {
        var language = session.language();
        setVisible(guide.isRunning());
        boolean isStep = guide.step().isPresent();
        title.setText(guide.step().map(GuideStep::title).orElse(READY).in(language));
        text.setText(guide.step().map(GuideStep::text).orElse(READY_TEXT).in(language));
        int number = guide.step().map(GuideStep::ordinal).orElse(GuideStep.values().length) + 1;
        count.setText(isStep ? COUNT.with(number, GuideStep.values().length).in(language) : "");
        prepare.setText(PREPARE.in(language));
        back.setText(BACK.in(language));
        skip.setText(SKIP.in(language));
        leave.setText(LEAVE.in(language));
        prepare.setEnabled(isStep);
        skip.setEnabled(isStep);
        back.setEnabled(number > 1);
        getAccessibleContext().setAccessibleName(NAME.in(language));
        Color accent = UIManager.getColor("Component.accentColor");
        setBorder(BorderFactory.createMatteBorder(0, 4, 1, 0, accent == null ? Color.ORANGE : accent));
        revalidate();
        repaint();
    }

    @Override
    public void close() {
        registration.close();
    }
}
