/** The third-person viewer of XML scenes: its controls and spring as values, and its window. */
package nephele.app.view;
