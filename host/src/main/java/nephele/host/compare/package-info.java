/** Two techniques of the same clouds over one view: drawn side by side under a wipe, with their times and their difference. */
package nephele.host.compare;
