/** Commands that run over folders of scans. */
package sunbeam.app.cli.collection;
