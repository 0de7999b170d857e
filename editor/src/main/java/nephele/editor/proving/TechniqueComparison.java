package nephele.editor.proving;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import nephele.editor.record.EntityRef;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.host.compare.TechniquePair;
import nephele.host.compare.Wipe;

/**
 * Two techniques of the selected cloud, drawn again after each change of the camera or of the level, also during a drag:
 * what is asked while a picture is drawn waits, and only the latest is drawn next.
 */
public final class TechniqueComparison {
    /** The section of the clouds in a level. */
    public static final String CLOUDS = "environment.clouds";

    /** Frames that follow the first one of a view, for the times. */
    private static final int TIMED_FRAMES = 6;

    private final ProvingSubject subject;
    private final Supplier<ProvingThreads> threads;
    private final AtomicLong asked = new AtomicLong();
    private boolean isVisible;
    private TechniquePair techniques;
    /** The written technique of the cloud that was followed last. */
    private CloudTechnique written;

    private Wipe wipe = Wipe.MIDDLE;
    private ComparedCloud wanted;
    private ComparedPictures pictures;
    private long received;
    private ComparisonThread thread;

    TechniqueComparison(ProvingSubject subject, Supplier<ProvingThreads> threads) {
        this.subject = subject;
        this.threads = threads;
    }

    public boolean isVisible() {
        return isVisible;
    }

    /** Returns the cloud that is selected alone; empty for any other selection. */
    public Optional<Cloud> cloud() {
        List<EntityRef> selected = subject.selection().entities();
        boolean isCloud = selected.size() == 1 && selected.get(0).section().equals(CLOUDS);
        return isCloud
                ? Optional.ofNullable(
                        ComparedCloud.find(subject.level(), selected.get(0).id()))
                : Optional.empty();
    }

    /** Begins to draw the selected cloud. */
    public void show() {
        isVisible = true;
        wanted = null;
        follow();
        subject.redraw();
    }

    /** Ends it, and gives back what it takes. */
    public void hide() {
        isVisible = false;
        wanted = null;
        pictures = null;
        asked.incrementAndGet();
        if (thread != null) {
            thread.close();
            thread = null;
        }
        subject.redraw();
    }

    /** Returns the techniques: at first that of the cloud, and the volume or what it is nearest to. */
    public TechniquePair techniques() {
        cloud().ifPresent(this::followTechnique);
        return techniques == null ? new TechniquePair(CloudTechnique.AUTO, CloudTechnique.VOLUME) : techniques;
    }

    /** Compares other techniques. */
    public void techniques(TechniquePair next) {
        techniques = next;
        cloud().ifPresent(cloud -> written = cloud.technique());
        follow();
        subject.redraw();
    }

    /** The left side follows the technique that the cloud is given. */
    private void followTechnique(Cloud cloud) {
        if (techniques == null) {
            techniques = usual(cloud);
        } else if (techniques.left() == written && cloud.technique() != written) {
            techniques = new TechniquePair(cloud.technique(), techniques.right());
        }
        written = cloud.technique();
    }

    private static TechniquePair usual(Cloud cloud) {
        CloudTechnique other =
                cloud.extent() instanceof Cloud.Extent.Volume ? CloudTechnique.PARTICLES : CloudTechnique.SKYPLANE;
        boolean isVolume = cloud.technique() == CloudTechnique.VOLUME;
        return new TechniquePair(cloud.technique(), isVolume ? other : CloudTechnique.VOLUME);
    }

    public Wipe wipe() {
        return wipe;
    }

    /** Moves the wipe; the pictures stay. */
    public void wipe(Wipe next) {
        wipe = next;
    }

    /** Returns the pictures that were drawn last; empty before the first. */
    public Optional<ComparedPictures> pictures() {
        return Optional.ofNullable(pictures);
    }

    void follow() {
        Cloud cloud = isVisible ? cloud().orElse(null) : null;
        if (cloud == null) {
            return;
        }
        followTechnique(cloud);
        ComparedCloud next = new ComparedCloud(
                subject.level(),
                subject.assets(),
                cloud.id(),
                techniques,
                PaneEye.of(subject).camera());
        if (next.isSame(wanted)) {
            return;
        }
        wanted = next;
        if (thread == null) {
            thread = new ComparisonThread();
        }
        ComparisonThread drawing = thread;
        long number = asked.incrementAndGet();
        threads.get().work().execute(() -> draw(drawing, next, number));
    }

    private void draw(ComparisonThread drawing, ComparedCloud next, long number) {
        for (int frames : new int[] {1, TIMED_FRAMES}) {
            if (number == asked.get()) {
                ComparedPictures drawn = drawing.draw(next, frames);
                threads.get().session().execute(() -> receive(drawn, number));
            }
        }
    }

    /** Takes pictures that are newer than those that are shown, even if newer ones are wanted already. */
    private void receive(ComparedPictures drawn, long number) {
        if (isVisible && number >= received) {
            received = number;
            pictures = drawn;
            subject.redraw();
        }
    }
}
