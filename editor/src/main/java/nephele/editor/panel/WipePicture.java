package nephele.editor.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import nephele.editor.proving.ComparedPictures;
import nephele.editor.proving.ComparisonThread;
import nephele.host.compare.Wipe;

/** Two pictures of the same view under a wipe that is dragged, or moved by the arrow keys. */
final class WipePicture extends JComponent {
    private static final long serialVersionUID = 1;

    private static final Color EMPTY = new Color(0x14171a);
    private static final Color INK = new Color(0xf3f6fa);
    private static final Color PLATE = new Color(0xd80b1119, true);
    private static final Color ACCENT = new Color(0x86ccff);
    private static final Color SHADOW = new Color(0x66000000, true);
    private static final double KEY_STEP = 0.02;

    private final transient Consumer<Wipe> moved;
    private transient ComparedPictures pictures;
    private transient Wipe wipe = Wipe.MIDDLE;

    /** @param moved receives the wipe after each movement by the user */
    WipePicture(Consumer<Wipe> moved) {
        this.moved = moved;
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.E_RESIZE_CURSOR));
        MouseAdapter drag = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                requestFocusInWindow();
                move(new Wipe((double) event.getX() / Math.max(1, getWidth())));
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                mousePressed(event);
            }
        };
        addMouseListener(drag);
        addMouseMotionListener(drag);
        addKeyListener(new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent event) {
                obey(event);
            }
        });
    }

    private void obey(KeyEvent event) {
        double step = event.isShiftDown() ? KEY_STEP / 10 : KEY_STEP;
        switch (event.getKeyCode()) {
            case KeyEvent.VK_LEFT -> move(wipe.moved(-step));
            case KeyEvent.VK_RIGHT -> move(wipe.moved(step));
            case KeyEvent.VK_HOME -> move(new Wipe(0));
            case KeyEvent.VK_END -> move(new Wipe(1));
            default -> {
                return;
            }
        }
        event.consume();
    }

    private void move(Wipe next) {
        wipe = next;
        moved.accept(next);
        repaint();
    }

    /** Shows pictures; {@code null} for none yet. */
    void show(ComparedPictures next, Wipe at) {
        pictures = next;
        wipe = at;
        repaint();
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                private static final long serialVersionUID = 1;

                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.SLIDER;
                }
            };
        }
        return accessibleContext;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(ComparisonThread.WIDTH), UIScale.scale(ComparisonThread.HEIGHT));
    }

    /** A low window takes its room from the fields above, which scroll. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(UIScale.scale(40), getPreferredSize().height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(EMPTY);
        g.fillRect(0, 0, getWidth(), getHeight());
        if (pictures != null && pictures.left() != null) {
            int column = wipe.column(getWidth());
            part(g, pictures.left(), 0, column);
            part(g, pictures.right(), column, getWidth());
            line(g, column);
        }
        g.dispose();
    }

    /** Covers the component, whose proportions may differ a little. */
    private void part(Graphics2D g, BufferedImage picture, int from, int to) {
        Graphics2D clipped = (Graphics2D) g.create();
        clipped.clipRect(from, 0, to - from, getHeight());
        double scale = Math.max((double) getWidth() / picture.getWidth(), (double) getHeight() / picture.getHeight());
        clipped.translate(getWidth() / 2.0, getHeight() / 2.0);
        clipped.scale(scale, scale);
        clipped.drawImage(picture, -picture.getWidth() / 2, -picture.getHeight() / 2, null);
        clipped.dispose();
    }

    private void line(Graphics2D g, double x) {
        double unit = UIScale.getUserScaleFactor();
        g.setColor(SHADOW);
        g.fill(new Rectangle2D.Double(x - 2 * unit, 0, 4 * unit, getHeight()));
        g.setColor(INK);
        g.fill(new Rectangle2D.Double(x - unit, 0, 2 * unit, getHeight()));
        double centre = Math.max(10 * unit, Math.min(x, getWidth() - 10 * unit));
        double top = getHeight() / 2.0 - 12 * unit;
        g.fill(new Rectangle2D.Double(centre - 10 * unit, top, 20 * unit, 24 * unit));
        g.setColor(PLATE);
        g.fill(new Rectangle2D.Double(centre - 9 * unit, top + unit, 18 * unit, 22 * unit));
        g.setColor(isFocusOwner() ? ACCENT : INK);
        arrow(g, centre, -unit);
        arrow(g, centre, unit);
    }

    private void arrow(Graphics2D g, double centre, double unit) {
        double middle = getHeight() / 2.0;
        double size = Math.abs(unit);
        var path = new Path2D.Double();
        path.moveTo(centre + 3 * unit, middle - 4 * size);
        path.lineTo(centre + 7 * unit, middle);
        path.lineTo(centre + 3 * unit, middle + 4 * size);
        path.closePath();
        g.fill(path);
    }
}
