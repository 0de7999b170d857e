package nephele.workshop.prove.process;

import com.sun.management.GarbageCollectionNotificationInfo;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import javax.management.ListenerNotFoundException;
import javax.management.Notification;
import javax.management.NotificationEmitter;
import javax.management.NotificationListener;
import javax.management.openmbean.CompositeData;

/** Records how long the garbage collector stops the program; its concurrent work does not count. */
final class CollectorPauses implements NotificationListener, AutoCloseable {
    private final List<NotificationEmitter> collectors = new ArrayList<>();
    private long longestMs;
    private long count;

    private CollectorPauses() {}

    static CollectorPauses listen() {
        var pauses = new CollectorPauses();
        for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
            if (collector instanceof NotificationEmitter emitter) {
                emitter.addNotificationListener(pauses, null, null);
                pauses.collectors.add(emitter);
            }
        }
        return pauses;
    }

    @Override
    public synchronized void handleNotification(Notification notification, Object handback) {
        if (!notification.getType().equals(GarbageCollectionNotificationInfo.GARBAGE_COLLECTION_NOTIFICATION)) {
            return;
        }
        var collection = GarbageCollectionNotificationInfo.from((CompositeData) notification.getUserData());
        boolean concurrent = collection.getGcName().contains("Concurrent")
                || collection.getGcName().contains("Cycles");
        if (!concurrent) {
            count++;
            longestMs = Math.max(longestMs, collection.getGcInfo().getDuration());
        }
    }

    synchronized long longestMs() {
        return longestMs;
    }

    synchronized long count() {
        return count;
    }

    @Override
    public void close() {
        for (var collector : collectors) {
            try {
                collector.removeNotificationListener(this);
            } catch (ListenerNotFoundException alreadyGone) {
                throw new IllegalStateException(alreadyGone);
            }
        }
    }
}
