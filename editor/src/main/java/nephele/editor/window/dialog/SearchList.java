package nephele.editor.window.dialog;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingConstants;
import javax.swing.UIManager;
import nephele.editor.widget.Listeners;
import nephele.engine.level.Language;

/** A list that typed words narrow; Up, Down, PageUp and PageDown move, Enter and a click choose, Esc ends it. */
public final class SearchList<T> extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int ROWS = 14;
    private static final int WIDTH_POINTS = 560;
    private static final int ROW_POINTS = 24;
    /**
     * The row of a search list for an element.
     *
     * @param aside what it belongs to, in a column of its own; may be empty
     * @param trailing such as its key, at the right end; may be empty
     * @param icon {@code null} for none
     */
    public record Row(String title, String aside, String trailing, Icon icon, boolean isEnabled) {
        /** Returns a row with a title alone. */
        public static Row of(String title, String aside) {
            return new Row(title, aside, "", null, true);
        }
    }

    /** Paints the rows of a search list in three columns that stay aligned from row to row. */
    private static final class SearchCell<T> extends JPanel implements ListCellRenderer<T> {
        private static final int INSET_POINTS = 8;
        private static final double ASIDE_AT = 0.56;
        private static final double TRAILING_AT = 0.76;

        private final transient Function<T, Row> rows;
        private final int rowPoints;
        private final JLabel title = new JLabel();
        private final JLabel aside = new JLabel();
        private final JLabel trailing = new JLabel("", SwingConstants.TRAILING);

        SearchCell(Function<T, Row> rows, int rowPoints) {
            super(null);
            this.rows = rows;
            this.rowPoints = rowPoints;
            add(title);
            add(aside);
            add(trailing);
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends T> list, T value, int index, boolean isSelected, boolean hasFocus) {
            Row row = rows.apply(value);
            title.setText(row.title());
            title.setIcon(row.icon());
            aside.setText(row.aside());
            trailing.setText(row.trailing());
            Color text = isSelected ? list.getSelectionForeground() : list.getForeground();
            Color faint = isSelected ? text : UIManager.getColor("Label.disabledForeground");
            title.setForeground(row.isEnabled() ? text : faint);
            aside.setForeground(faint);
            trailing.setForeground(isSelected ? text : faint);
            setBackground(isSelected ? list.getSelectionBackground() : list.getBackground());
            setToolTipText(row.title());
            getAccessibleContext().setAccessibleName(row.title() + " " + row.aside() + " " + row.trailing());
            return this;
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(UIScale.scale(360), UIScale.scale(rowPoints));
        }

        @Override
        public void doLayout() {
            int inset = UIScale.scale(INSET_POINTS);
            int end = getWidth() - inset;
            int asideAt = aside.getText().isEmpty() ? end : (int) (ASIDE_AT * getWidth());
            int trailingAt = trailing.getText().isEmpty() ? end : (int) (TRAILING_AT * getWidth());
            title.setBounds(inset, 0, Math.min(asideAt, trailingAt) - inset, getHeight());
            aside.setBounds(asideAt, 0, Math.max(0, trailingAt - asideAt - inset / 2), getHeight());
            trailing.setBounds(trailingAt, 0, Math.max(0, end - trailingAt), getHeight());
        }

        /** Lays out at once: a cell has no window, and without a display validation would do nothing. */
        @Override
        public void validate() {
            doLayout();
        }
    }

    private final JTextField query = new JTextField();
    private final DefaultListModel<T> found = new DefaultListModel<>();
    private final JList<T> list = new JList<>(found);
    private final JPanel results = new JPanel(new CardLayout());
    private final transient Function<String, List<T>> find;
    private final transient Function<T, Row> rows;
    private final transient Consumer<Optional<T>> done;

    /** Creates a list that shows what an empty query finds, in rows of the usual height. */
    public SearchList(
            DialogText prompt,
            Function<String, List<T>> find,
            Function<T, Row> rows,
            Consumer<Optional<T>> done,
            Language language) {
        this(prompt, find, rows, done, language, ROW_POINTS);
    }

    /**
     * Creates a list that shows what an empty query finds.
     *
     * @param find returns the elements that a query finds, in order
     * @param done receives the chosen element, or nothing if the user gives up
     * @param rowPoints height of a row at 100 %
     */
    SearchList(
            DialogText prompt,
            Function<String, List<T>> find,
            Function<T, Row> rows,
            Consumer<Optional<T>> done,
            Language language,
            int rowPoints) {
        super(new BorderLayout(0, UIScale.scale(6)));
        this.find = find;
        this.rows = rows;
        this.done = done;
        int margin = UIScale.scale(8);
        setBorder(BorderFactory.createEmptyBorder(margin, margin, margin, margin));
        query.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, prompt.in(language));
        query.getAccessibleContext().setAccessibleName(prompt.in(language));
        Listeners.onText(query, this::refind);
        query.addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent event) {
                pressed(event);
            }
        });
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new SearchCell<>(rows, rowPoints));
        list.setFixedCellHeight(UIScale.scale(rowPoints));
        list.setVisibleRowCount(ROWS * ROW_POINTS / rowPoints);
        list.setFocusable(false);
        list.getAccessibleContext().setAccessibleName(DialogText.RESULTS.in(language));
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                choose();
            }
        });
        JScrollPane scroll = new JScrollPane(
                list, ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        results.add(scroll, "found");
        results.add(new JLabel(DialogText.NOTHING_FOUND.in(language), SwingConstants.CENTER), "nothing");
        add(query, BorderLayout.PAGE_START);
        add(results);
        refind();
    }

    private void pressed(KeyEvent event) {
        switch (event.getKeyCode()) {
            case KeyEvent.VK_ENTER -> choose();
            case KeyEvent.VK_ESCAPE -> done.accept(Optional.empty());
            case KeyEvent.VK_DOWN -> step(1);
            case KeyEvent.VK_UP -> step(-1);
            case KeyEvent.VK_PAGE_DOWN -> step(list.getVisibleRowCount());
            case KeyEvent.VK_PAGE_UP -> step(-list.getVisibleRowCount());
            default -> {
                return;
            }
        }
        event.consume();
    }

    private void refind() {
        found.clear();
        find.apply(query.getText()).forEach(found::addElement);
        list.setSelectedIndex(0);
        list.ensureIndexIsVisible(0);
        ((CardLayout) results.getLayout()).show(results, found.isEmpty() ? "nothing" : "found");
    }

    private void step(int count) {
        int next = Math.max(0, Math.min(found.size() - 1, list.getSelectedIndex() + count));
        list.setSelectedIndex(next);
        list.ensureIndexIsVisible(next);
    }

    private void choose() {
        T chosen = list.getSelectedValue();
        if (chosen != null && rows.apply(chosen).isEnabled()) {
            done.accept(Optional.of(chosen));
        }
    }

    /** Returns the field for the search words, which receives all keys. */
    public JTextField query() {
        return query;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(WIDTH_POINTS), super.getPreferredSize().height);
    }
}
